// SPDX-License-Identifier: MIT
#include "cases.hpp"
#include "support/bench/plot.hpp"

namespace rigor {

void plot_case(const AccuracyCase& accuracy_case, const std::vector<Curve>& curves,
               const std::string& folder)
{
    Plot plot;
    plot.title = accuracy_case.title;
    plot.x_label = "run time [s]";
    plot.y_label = accuracy_case.error;
    for (const Curve& curve : curves) {
        Series& series = plot.series.emplace_back();
        series.name = curve.contestant.name();
        series.dashed = !curve.contestant.is_ours();
        for (const Point& point : curve.points)
            series.points.emplace_back(point.seconds, point.error);
    }
    write_plot(plot, folder + "/" + accuracy_case.name + ".svg");
}

} // namespace rigor
