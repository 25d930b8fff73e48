#include "io/npz.h"

#include "io/file.h"

#include <aureole/rhi/error.h>

#include <zip.h>
#include <algorithm>
#include <cstdint>
#include <memory>
#include <string_view>

namespace aureole::app {
namespace {

constexpr std::uint64_t most_bytes = 1ull << 31;
constexpr std::size_t chunk_bytes = std::size_t{1} << 22;

struct CloseArchive {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseEntry {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using Archive = std::unique_ptr<zip_t, CloseArchive>;
using Entry = std::unique_ptr<zip_file_t, CloseEntry>;

Archive open_archive(const std::filesystem::path& path) {
    int code = 0;
    Archive archive(zip_open(path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code));
    if (archive) return archive;
    zip_error_t problem;
    zip_error_init_with_code(&problem, code);
    const std::string text = zip_error_strerror(&problem);
    zip_error_fini(&problem);
    throw Error(ErrorCode::io, path.string() + ": not a readable .npz archive: " + text);
}

std::vector<std::byte> read_entry(zip_t* archive, zip_uint64_t index, const std::string& where) {
    const auto fail = [&](const std::string& what) { return Error(ErrorCode::io, where + ": cannot be unpacked: " + what); };
    zip_stat_t entry;
    zip_stat_init(&entry);
    if (zip_stat_index(archive, index, 0, &entry) != 0 || !(entry.valid & ZIP_STAT_SIZE)) throw fail(zip_strerror(archive));
    // The two that NumPy writes: deflated bytes hold a thousand others at most, where bzip2's hold millions.
    if (entry.comp_method != ZIP_CM_STORE && entry.comp_method != ZIP_CM_DEFLATE)
        throw fail("it is neither stored nor deflated");
    if (entry.size > most_bytes) throw fail("it is larger than 2 GiB");
    const Entry file(zip_fopen_index(archive, index, 0));
    if (!file) throw fail(zip_strerror(archive));
    // Room is made for what has come, not for what the archive promises.
    std::vector<std::byte> bytes;
    while (bytes.size() < entry.size) {
        const std::size_t have = bytes.size();
        bytes.resize(std::min(static_cast<std::size_t>(entry.size), have + chunk_bytes));
        const zip_int64_t got = zip_fread(file.get(), bytes.data() + have, bytes.size() - have);
        if (got < 0) throw fail(zip_file_strerror(file.get()));
        if (got == 0) throw fail("it ends too early");
        bytes.resize(have + static_cast<std::size_t>(got));
    }
    std::byte beyond;  // libzip checks the check sum only when it meets the end
    if (zip_fread(file.get(), &beyond, 1) != 0) throw fail(zip_file_strerror(file.get()));
    return bytes;
}

}  // namespace

struct NpzFile::Impl {
    std::filesystem::path path;
    Archive archive;
    std::vector<std::string> names;
    std::vector<zip_uint64_t> indices;
};

NpzFile::NpzFile(const std::filesystem::path& path) {
    (void)read_file(path);  // says in our words what is wrong with the name
    impl_ = std::make_unique<Impl>(Impl{path, open_archive(path), {}, {}});
    const zip_int64_t count = zip_get_num_entries(impl_->archive.get(), 0);
    for (zip_int64_t i = 0; i < count; ++i) {
        const char* raw = zip_get_name(impl_->archive.get(), static_cast<zip_uint64_t>(i), 0);
        const std::string_view name = raw ? raw : "";
        if (!name.ends_with(".npy")) continue;
        impl_->names.emplace_back(name.substr(0, name.size() - 4));
        impl_->indices.push_back(static_cast<zip_uint64_t>(i));
    }
    if (impl_->names.empty()) throw Error(ErrorCode::io, path.string() + ": holds no NumPy array");
}

NpzFile::~NpzFile() = default;

const std::vector<std::string>& NpzFile::names() const noexcept { return impl_->names; }

bool NpzFile::has(const std::string& name) const { return std::ranges::find(impl_->names, name) != impl_->names.end(); }

NpyArray NpzFile::read(const std::string& name) const {
    const std::string where = impl_->path.string() + ": " + name + ".npy";
    const auto found = std::ranges::find(impl_->names, name);
    if (found == impl_->names.end()) throw Error(ErrorCode::io, where + ": there is no such array");
    const zip_uint64_t index = impl_->indices[static_cast<std::size_t>(found - impl_->names.begin())];
    return parse_npy(read_entry(impl_->archive.get(), index, where), where);
}

}  // namespace aureole::app
