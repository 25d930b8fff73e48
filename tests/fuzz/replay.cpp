// In place of libFuzzer, for every compiler: gives the reader all that is kept in a folder, as it is and with changes that are
// the same in every run. `PROGRAM FOLDER|FILE... [--changes N]`. What a run ends at is left in `failed_input`.
#include "fuzz.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>
#include <algorithm>
#include <csignal>
#include <exception>
#include <random>
#include <vector>

// Of the sanitizers, which end a program without a signal: the name is theirs.
// NOLINTNEXTLINE(bugprone-reserved-identifier)
extern "C" __attribute__((weak)) void __sanitizer_set_death_callback(void (*)());

namespace {

using Input = std::vector<std::uint8_t>;

constexpr unsigned most_seconds = 20;  // of one input, on a machine that has other work
constexpr std::size_t longest = 1 << 16;
Input current;

/// As the signal handler it is, it may not allocate.
void keep_input() {
    const int file = ::open("failed_input", O_CREAT | O_TRUNC | O_WRONLY, 0644);
    const bool kept = file >= 0 && ::write(file, current.data(), current.size()) >= 0;
    constexpr char kept_text[] = "the input is in failed_input\n", lost_text[] = "the input cannot be kept\n";
    (void)!::write(2, kept ? kept_text : lost_text, kept ? sizeof kept_text - 1 : sizeof lost_text - 1);
}
extern "C" void on_signal(int signal) {
    keep_input();
    ::raise(signal);
}

Input read(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void run(Input input) {
    current = std::move(input);
    ::alarm(most_seconds);
    (void)LLVMFuzzerTestOneInput(current.data(), current.size());
    ::alarm(0);
}

/// Bits, bytes, digits, lengths; a piece taken out, doubled, or from another input.
void change(Input& input, const std::vector<Input>& others, std::mt19937& random) {
    const auto below = [&](std::size_t count) { return count == 0 ? 0 : random() % count; };
    const std::size_t at = below(input.size()), length = std::min(below(64) + 1, input.size() - at);
    const auto place = input.begin() + static_cast<std::ptrdiff_t>(at);
    const auto piece_of = [&](const Input& from) {
        const std::size_t start = below(from.size()), end = std::min(start + below(64) + 1, from.size());
        return Input(from.begin() + static_cast<std::ptrdiff_t>(start), from.begin() + static_cast<std::ptrdiff_t>(end));
    };
    if (input.empty()) return input.push_back(static_cast<std::uint8_t>(random()));
    switch (below(8)) {
        case 0:
            *place ^= static_cast<std::uint8_t>(1U << below(8));
            break;
        case 1:
            *place = static_cast<std::uint8_t>(random());
            break;
        case 2: {
            constexpr std::uint8_t ends[] = {0,   1,    0x7F, 0x80, 0xFE, 0xFF, '0', '9', '-',
                                             '"', '\'', '[',  ']',  '{',  '}',  '.', ',', '\n'};
            *place = ends[below(std::size(ends))];
            break;
        }
        case 3:
            std::fill_n(place, std::min<std::size_t>(length, 4), static_cast<std::uint8_t>(below(2) * 255));
            break;
        case 4:
            input.resize(at);
            break;
        case 5:
            input.erase(place, place + static_cast<std::ptrdiff_t>(length));
            break;
        default: {
            const Input piece = piece_of(below(2) == 0 ? input : others[below(others.size())]);
            if (input.size() + piece.size() <= longest) input.insert(place, piece.begin(), piece.end());
        }
    }
}

/// A reader that makes room for what a broken file promises ends here, and not in the machine's memory.
void bound_memory() {
    if (__sanitizer_set_death_callback != nullptr) return;  // sanitizers reserve more than that
    constexpr rlim_t most_bytes = rlim_t{2} << 30;
    const rlimit limit{most_bytes, most_bytes};
    ::setrlimit(RLIMIT_AS, &limit);
}

}  // namespace

int main(int count, char** arguments) {
    std::size_t changes = 0;
    std::vector<std::filesystem::path> files;
    for (int i = 1; i < count; ++i) {
        const std::string argument = arguments[i];
        if (argument == "--changes" && i + 1 < count)
            changes = std::stoul(arguments[++i]);
        else if (std::filesystem::is_directory(argument))
            for (const auto& entry : std::filesystem::directory_iterator(argument)) files.push_back(entry.path());
        else
            files.emplace_back(argument);
    }
    std::ranges::sort(files);
    std::vector<Input> inputs;
    inputs.reserve(files.size());
    for (const std::filesystem::path& file : files) inputs.push_back(read(file));
    if (inputs.empty()) return std::fprintf(stderr, "usage: replay FOLDER|FILE... [--changes N]\n"), 2;

    bound_memory();
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGALRM}) {
        struct sigaction action {};
        action.sa_handler = on_signal;
        action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
        ::sigaction(signal, &action, nullptr);
    }
    if (__sanitizer_set_death_callback != nullptr) __sanitizer_set_death_callback(keep_input);
    std::mt19937 random(1);
    std::size_t runs = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        std::printf("%s\n", files[i].filename().c_str());
        std::fflush(stdout);
        run(inputs[i]);
        Input changed;
        for (std::size_t c = 0; c < changes; ++c) {
            if (c % 4 == 0) changed = inputs[i];
            change(changed, inputs, random);
            run(changed);
        }
        runs += 1 + changes;
    }
    std::printf("%zu inputs\n", runs);
    return 0;
}
