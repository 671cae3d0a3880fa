#include "sweeps/plots.hpp"
#include "base/OutputFile.hpp"
#include "sweeps/convergence.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace sph
{

namespace
{

struct Curve
{
    std::string name;
    bool peer = false;
    std::vector<const ResultRow*> rows; ///< coarse first
};

std::vector<Curve> curvesOf(const Diagram& diagram)
{
    std::vector<Curve> curves;
    const auto add = [&](const std::vector<ResultRow>& rows, bool peer)
    {
        for (const auto& row : rows)
        {
            if (!row.drawable()) continue;
            auto curve = std::ranges::find_if(curves, [&](const Curve& c) { return c.name == row.variant && c.peer == peer; });
            if (curve == curves.end()) curve = curves.insert(curves.end(), {row.variant, peer, {}});
            curve->rows.push_back(&row);
        }
    };
    add(diagram.rows, false);
    add(diagram.peers, true);
    for (auto& curve : curves) std::ranges::stable_sort(curve.rows, std::greater<>(), [](const ResultRow* row) { return row->spacing; });
    return curves;
}

/// Range of an axis, with room beside the outermost points; whole decades, gnuplot's own choice, leave most of a plot empty.
std::string rangeOf(const std::vector<Curve>& curves, double ResultRow::*value)
{
    constexpr double room = 1.6;
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (const auto& curve : curves)
        for (const auto* row : curve.rows)
        {
            low = std::min(low, row->*value);
            high = std::max(high, row->*value);
        }
    return fmt::format("[{:.4g}:{:.4g}]", low / room, high * room);
}

/// Text in single quotes, in which gnuplot reads everything as it is, but for the quote itself.
std::string quoted(const std::string& text)
{
    std::string inner;
    for (const char c : text) inner += c == '\'' ? std::string("''") : std::string(1, c == '\n' ? ' ' : c);
    return "'" + inner + "'";
}

std::optional<PowerLaw> slopeOf(const Curve& curve)
{
    std::vector<double> x, y;
    for (const auto* row : curve.rows)
    {
        x.push_back(row->spacing);
        y.push_back(row->error);
    }
    return fitPowerLaw(x, y);
}

/// Line style by the curve's number: ours filled and joined, those of other codes open and dotted.
std::string lineStyle(std::size_t k, const Curve& curve)
{
    static const char* colours[] = {"#0060ad", "#dd181f", "#1a8a34", "#8e44ad", "#e08214", "#16a0b0", "#7f4f24", "#555555"};
    return fmt::format("lc rgb '{}' lw 1.6{}", colours[k % std::size(colours)], curve.peer ? " dt 3" : "");
}

std::string markStyle(std::size_t k, const Curve& curve)
{
    static const int filled[] = {7, 5, 9, 11, 13, 15}, open[] = {6, 4, 8, 10, 12, 14};
    return fmt::format("pt {} ps 1.1", curve.peer ? open[k % std::size(open)] : filled[k % std::size(filled)]);
}

std::string plotCommand(const std::vector<Curve>& curves, bool againstSpacing)
{
    std::string command;
    const auto add = [&](const std::string& part) { command += (command.empty() ? "plot " : ", \\\n     ") + part; };
    for (std::size_t k = 0; k < curves.size(); ++k)
    {
        const auto& curve = curves[k];
        const auto slope = againstSpacing ? slopeOf(curve) : std::nullopt;
        const auto title = slope ? fmt::format("{}, order {:.2f}", curve.name, slope->exponent) : curve.name;
        add(fmt::format("$curve{} using {}:3 with {} {} {} title {}", k, againstSpacing ? 1 : 2, slope ? "points" : "linespoints",
                        lineStyle(k, curve), markStyle(k, curve), quoted(title)));
        // The fitted slope, over the range of its points.
        if (slope)
        {
            const double fine = curve.rows.back()->spacing, coarse = curve.rows.front()->spacing;
            add(fmt::format("[h={}:{}] '+' using (h):({}*h**{}) with lines {} notitle", shortestText(fine), shortestText(coarse),
                            shortestText(slope->factor), shortestText(slope->exponent), lineStyle(k, curve)));
        }
    }
    return command + "\n";
}

}

std::string gnuplotScript(const Diagram& diagram)
{
    const auto curves = curvesOf(diagram);
    if (curves.empty()) return "";
    std::string script = "# Written by workPrecision; draws itself again with `gnuplot " + diagram.stem + ".gp`.\n";
    for (std::size_t k = 0; k < curves.size(); ++k)
    {
        script += fmt::format("$curve{} << END_OF_CURVE\n# spacing [m]  processor time [s]  error\n", k);
        for (const auto* row : curves[k].rows)
            script += fmt::format("{} {} {}\n", shortestText(row->spacing), shortestText(row->cpuSeconds), shortestText(row->error));
        script += "END_OF_CURVE\n";
    }
    script += fmt::format("set encoding utf8\nset logscale xy\nset format '%.0e'\nset grid xtics ytics mxtics mytics lc rgb '#999999', "
                          "lc rgb '#dddddd'\nset key below Left reverse height 1 spacing 1.2 samplen 3 noenhanced\nset samples 50\nset "
                          "title {} noenhanced\n"
                          "set ylabel 'error'\nset yrange {}\n",
                          quoted(diagram.title), rangeOf(curves, &ResultRow::error));
    for (const bool againstSpacing : {false, true})
    {
        script += fmt::format("\nset xlabel '{}'\nset xrange {}\n", againstSpacing ? "spacing [m]" : "processor time [s]",
                              rangeOf(curves, againstSpacing ? &ResultRow::spacing : &ResultRow::cpuSeconds));
        const auto command = plotCommand(curves, againstSpacing);
        for (const bool svg : {true, false})
            script +=
                fmt::format("set terminal {}\nset output {}\n{}",
                            svg ? "svg size 720,600 dynamic background rgb 'white'" : "pngcairo size 1080,900 fontscale 1.3",
                            quoted(fmt::format("{}.{}.{}", diagram.stem, againstSpacing ? "spacing" : "cpuTime", svg ? "svg" : "png")),
                            command);
    }
    return script + "unset output\n";
}

}
