"""Names of headings as GitHub makes them, so that links to them are good in both places."""
import re


def slug(title, separator):
    return re.sub(r'[^\w\- ]', '', re.sub(r'<[^>]*>', '', title).lower()).strip().replace(' ', separator)
