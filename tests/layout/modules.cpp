// SPDX-License-Identifier: MIT
// Finds modules that include each other. The includes of all files make a graph of modules. Its
// strongly connected components (Tarjan 1972) are found by a depth-first search; those of several
// modules are cycles.
#include "layout/modules.hpp"

#include <algorithm>
#include <regex>

namespace rigor::layout {

namespace {

namespace fs = std::filesystem;

class Components {
public:
    explicit Components(const Includes& includes) : includes_(includes)
    {
        for (const auto& [module, included] : includes)
            if (!order_.count(module)) visit(module);
    }

    std::vector<std::vector<std::string>> found;

private:
    // @return the oldest module on the path that this module reaches, as its place in the order
    std::size_t visit(const std::string& module)
    {
        const std::size_t own = order_.size();
        std::size_t oldest = order_[module] = own;
        path_.push_back(module);
        for (const std::string& next : includes_.at(module)) {
            if (!order_.count(next))
                oldest = std::min(oldest, visit(next));
            else if (std::find(path_.begin(), path_.end(), next) != path_.end())
                oldest = std::min(oldest, order_[next]);
        }
        if (oldest == own) close(module);
        return oldest;
    }

    void close(const std::string& module)
    {
        const auto start = std::find(path_.begin(), path_.end(), module);
        std::vector<std::string> component(start, path_.end());
        path_.erase(start, path_.end());
        std::sort(component.begin(), component.end());
        if (component.size() > 1) found.push_back(std::move(component));
    }

    const Includes& includes_;
    std::map<std::string, std::size_t> order_; // the order in which modules were reached
    std::vector<std::string> path_;
};

} // namespace

std::string module_of(const fs::path& file)
{
    return (file.parent_path() / file.stem()).generic_string();
}

Includes module_includes(const Files& sources)
{
    std::set<fs::path> known;
    for (const File& file : sources)
        known.insert(file.path);
    static const std::regex include("\\s*#\\s*include\\s+\"([^\"]+)\".*");
    Includes result;
    for (const File& file : sources) {
        const std::string module = module_of(file.path);
        std::set<std::string>& included = result[module];
        for (const std::string& line : file.lines) {
            std::smatch match;
            if (line.find("#") == std::string::npos || !std::regex_match(line, match, include))
                continue;
            for (const fs::path& base :
                 {fs::path("framework"), fs::path("tests"), file.path.parent_path()}) {
                const fs::path path = (base / match[1].str()).lexically_normal();
                if (!known.count(path)) continue;
                if (module_of(path) != module) included.insert(module_of(path));
                break;
            }
        }
    }
    return result;
}

std::vector<std::vector<std::string>> cycles(const Includes& includes)
{
    return Components(includes).found;
}

} // namespace rigor::layout
