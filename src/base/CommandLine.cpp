#include "base/CommandLine.hpp"
#include "base/CaseError.hpp"
#include "base/version.hpp"
#include "base/words.hpp"
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fmt/format.h>
#include <iostream>

namespace sph
{

namespace
{

/// "-name" as the user types it, from any of CLI11's ways to write it.
std::string typed(const CLI::Option& option)
{
    return option.get_lnames().empty() ? "-" + option.get_snames().front() : "-" + option.get_lnames().front();
}

/// Usage in the layout of OpenFOAM's -help.
class UsageFormatter : public CLI::Formatter
{
    static std::string valueName(const CLI::Option& option)
    {
        if (option.get_items_expected_max() == 0) return "";
        const auto type = option.get_type_name();
        return type.empty() || type.front() == '<' ? type : "<" + type + ">";
    }

public:
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode) const override
    {
        std::string arguments, lines;
        for (const auto* option : app->get_options({}))
        {
            if (option->get_positional())
            {
                const auto shown = fmt::format("<{}>", option->get_name());
                arguments += option->get_required() ? " " + shown : " [" + shown + "]";
                lines += fmt::format("  {:<25} {}\n", shown, option->get_description());
                continue;
            }
            const auto left = typed(*option) + (valueName(*option).empty() ? "" : " " + valueName(*option));
            lines += left.size() > 25 ? fmt::format("  {}\n{:28}{}\n", left, "", option->get_description())
                                      : fmt::format("  {:<25} {}\n", left, option->get_description());
        }
        return fmt::format("\nUsage: {} [OPTIONS]{}\nOptions:\n{}\n{}\n\n", name, arguments, lines, app->get_description());
    }
};

/// CLI11 says "--entry: 1 required TEXT missing"; the user typed "-entry".
std::string withSingleDashes(std::string message)
{
    for (auto at = message.find("--"); at != std::string::npos; at = message.find("--", at + 1)) message.erase(at, 1);
    return message;
}

[[noreturn]] void refuse(const CLI::App& app, std::string unexpected)
{
    if (unexpected.front() != '-') throw CaseError(fmt::format("Unexpected argument \"{}\"", unexpected));
    std::vector<std::string> known;
    for (const auto* option : app.get_options({}))
        if (!option->get_positional()) known.push_back(typed(*option));
    unexpected = withSingleDashes(unexpected);
    throw CaseError(fmt::format("Invalid option {}. {}", unexpected, suggestion(unexpected, "options", known)));
}

}

CommandLine::Option CommandLine::Option::required()
{
    option_->required();
    return *this;
}

CommandLine::Option CommandLine::Option::positive()
{
    option_->check(CLI::PositiveNumber);
    return *this;
}

CommandLine::Option CommandLine::Option::within(int least, int most)
{
    option_->check(CLI::Range(least, most));
    return *this;
}

CommandLine::Option CommandLine::Option::commaSeparated()
{
    option_->delimiter(',');
    return *this;
}

CommandLine::Option CommandLine::Option::valueOptional()
{
    option_->expected(0, 1);
    return *this;
}

CommandLine::Option CommandLine::Option::needs(Option other)
{
    option_->needs(other.option_);
    return *this;
}

CommandLine::Option CommandLine::Option::excludes(Option other)
{
    option_->excludes(other.option_);
    return *this;
}

bool CommandLine::Option::given() const { return option_->count() > 0; }

CommandLine::Option CommandLine::flag(const std::string& name, bool& value, const std::string& meaning)
{
    return Option(app_.add_flag("--" + name, value, meaning));
}

template<class Value>
CommandLine::Option CommandLine::option(const std::string& name, Value& value, const std::string& type, const std::string& meaning)
{
    return Option(app_.add_option("--" + name, value, meaning)->type_name("<" + type + ">"));
}

template<class Value> CommandLine::Option CommandLine::argument(const std::string& name, Value& value, const std::string& meaning)
{
    return Option(app_.add_option(name, value, meaning));
}

template CommandLine::Option CommandLine::option(const std::string&, std::string&, const std::string&, const std::string&);
template CommandLine::Option CommandLine::option(const std::string&, double&, const std::string&, const std::string&);
template CommandLine::Option CommandLine::option(const std::string&, int&, const std::string&, const std::string&);
template CommandLine::Option CommandLine::option(const std::string&, std::optional<double>&, const std::string&, const std::string&);
template CommandLine::Option CommandLine::option(const std::string&, std::vector<std::string>&, const std::string&, const std::string&);
template CommandLine::Option CommandLine::argument(const std::string&, std::string&, const std::string&);
template CommandLine::Option CommandLine::argument(const std::string&, double&, const std::string&);
template CommandLine::Option CommandLine::argument(const std::string&, std::vector<std::string>&, const std::string&);

std::vector<std::string> openFoamArguments(int argc, const char* const* argv)
{
    std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
    for (auto& a : arguments)
    {
        if (a == "--") break;
        if (a.size() > 2 && a[0] == '-' && std::isalpha(static_cast<unsigned char>(a[1]))) a.insert(0, "-");
        else if (a.size() > 2 && a[0] == '-' && a[1] == '.') a.insert(1, "0");
    }
    return arguments;
}

int runApplication(const std::string& name, int argc, const char* const* argv, const std::string& description,
                   const std::function<void(CommandLine&)>& options, const std::function<int(const std::filesystem::path&)>& body,
                   Banner head)
{
    const auto fail = [&](const std::string& what, const std::string& hint = "")
    {
        std::cout.flush();
        std::fflush(stdout);
        std::fputs(fmt::format("--> FATAL ERROR\n{}\n{}", what, hint).c_str(),
                   stderr); // fmt::print would throw where a full disk holds stderr
        return 1;
    };
    // A log that gets both streams has them in the order in which they were written, whoever writes (libraries too): in a file the C
    // library would keep back some pages of standard output, and nothing of standard error.
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    std::filesystem::path caseFolder = ".";
    CLI::App app(description, name);
    try
    {
        app.formatter(std::make_shared<UsageFormatter>());
        app.set_help_flag("-h,--help", "Print this usage");
        app.set_version_flag("--version", fmt::format("{} {}", name, version().text()), "Print the version");
        app.add_option("--case", caseFolder, "Case folder, instead of the current one")->type_name("<dir>");
        app.allow_extras();
        CommandLine line(app);
        options(line);

        auto arguments = openFoamArguments(argc, argv);
        std::reverse(arguments.begin(), arguments.end());
        app.parse(arguments);
        if (const auto rest = app.remaining(); !rest.empty()) refuse(app, rest.front());
        if (!std::filesystem::is_directory(caseFolder)) throw CaseError(fmt::format("There is no case folder \"{}\"", caseFolder.string()));
    }
    catch (const CLI::CallForHelp&)
    {
        fmt::print("{}", app.help());
        return 0;
    }
    catch (const CLI::CallForVersion& version)
    {
        fmt::print("{}\n", version.what());
        return 0;
    }
    catch (const std::exception& error)
    {
        return fail(withSingleDashes(error.what()), fmt::format("See '{} -help' for usage\n", name));
    }

    try
    {
        if (head == Banner::shown) fmt::print("{}", banner(name, caseFolder));
        return body(caseFolder);
    }
    catch (const CaseError& error)
    {
        return fail(error.what());
    }
    catch (const std::exception& error)
    {
        return fail(fmt::format("{} stopped unexpectedly: {}", name, error.what()));
    }
}

}
