// SPDX-License-Identifier: MIT
#include "scene/trajectory/trajectory_file.hpp"

#include "errors/input_error.hpp"
#include "scene/trajectory/reader.hpp"

#include <fstream>

namespace rigor {

Trajectory load_trajectory(const std::filesystem::path& file)
{
    std::error_code error;
    std::ifstream stream(file, std::ios::binary);
    if (!stream || !std::filesystem::is_regular_file(file, error))
        throw InputError(
            fmt::format("{}: expected a trajectory file, found {}", file.string(),
                        std::filesystem::exists(file, error) ? "something else" : "nothing"));
    Trajectory trajectory;
    TrajectoryReader reader(trajectory);
    try {
        std::vector<char> chunk(1 << 16);
        while (stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size())),
               stream.gcount() > 0)
            reader.feed(std::as_bytes(std::span(chunk.data(), stream.gcount())));
        if (!reader.started()) fail("header", "a whole one", "the end of the file");
    } catch (const InputError& mistake) {
        throw InputError(fmt::format("{}: {}", file.string(), mistake.what()));
    }
    return trajectory;
}

} // namespace rigor
