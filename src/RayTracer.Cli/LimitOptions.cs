using System.CommandLine;
using System.Globalization;
using RayTracer.Description;
using RayTracer.Import;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary>
/// The options <c>--memory</c>, <c>--work</c>, <c>--root</c>, <c>--strict</c>, <c>--lenient</c> and <c>--define</c> of all verbs: the limits of what a scene may take,
/// read and lack, and what scenes of other programs are given.
/// </summary>
internal static class LimitOptions
{
    private static readonly Option<string> s_memory = new("--memory")
    {
        Description = "The most memory that a scene's pictures, triangles and instances may take, such as 512M or 16G; by default 4 GiB, or half of what there is.",
        HelpName = "SIZE",
        Recursive = true,
    };

    private static readonly Option<string> s_work = new("--work")
    {
        Description = "The most work that a scene may cost before it is rendered, in steps, such as 500M: one for each pixel or byte that is read, 16 for each triangle, "
            + "100 for each instance; 4G without it.",
        HelpName = "STEPS",
        Recursive = true,
    };

    private static readonly Option<string> s_root = new("--root")
    {
        Description = "Refuses files of scenes that are not in this folder or below it: for scenes of people that are not trusted.",
        HelpName = "FOLDER",
        Recursive = true,
    };

    private static readonly Option<bool> s_strict = new("--strict")
    {
        Description = "Makes errors of what is otherwise replaced with a warning: pictures and material files that are missing, statements of MTL files that are wrong.",
        Recursive = true,
    };

    private static readonly Option<bool> s_lenient = new("--lenient")
    {
        Description = "Renders what can be rendered of a scene of Mitsuba or pbrt: what is not supported is a warning, and something magenta stands in for it.",
        Recursive = true,
    };

    private static readonly Option<string[]> s_define = new("--define", "-D")
    {
        Description = "Gives a parameter of a scene of Mitsuba ($name) a value. May be given several times.",
        HelpName = "NAME=VALUE",
        Recursive = true,
    };

    private static readonly (string Letter, int Shift)[] s_units = [("K", 10), ("M", 20), ("G", 30), ("T", 40)];

    /// <summary>Gives a command, and those under it, the options.</summary>
    public static void AddTo(Command command)
    {
        command.Options.Add(s_memory);
        command.Options.Add(s_work);
        command.Options.Add(s_root);
        command.Options.Add(s_strict);
        command.Options.Add(s_lenient);
        command.Options.Add(s_define);
    }

    /// <summary>Sets the limits that are given, for all that the process reads.</summary>
    /// <exception cref="CommandException">A value is wrong.</exception>
    public static void Apply(ParseResult result)
    {
        StandIn.IsError = result.GetValue(s_strict);
        ImportSettings.IsLenient = result.GetValue(s_lenient);
        ImportSettings.Parameters = (result.GetValue(s_define) ?? []).Select(Definition).GroupBy(d => d.Name).ToDictionary(g => g.Key, g => g.Last().Value);
        if (result.GetValue(s_memory) is { } size)
        {
            SceneBudget.Limit = Amount("--memory", size);
        }

        if (result.GetValue(s_work) is { } steps)
        {
            SceneBudget.WorkLimit = Amount("--work", steps);
        }

        if (result.GetValue(s_root) is { } root)
        {
            SceneFolder.Root = Directory.Exists(root) ? root : throw new CommandException(ExitStatus.Usage, $"--root: there is no folder '{root}'");
        }
    }

    private static (string Name, string Value) Definition(string word) => word.Split('=', 2) is [{ Length: > 0 } name, var value]
        ? (name, value)
        : throw new CommandException(ExitStatus.Usage, $"--define must be a name and a value, such as radius=2, but is {Quotation.Of(word)}");

    private static long Amount(string option, string size)
    {
        string number = size.ToUpperInvariant().TrimEnd('B').TrimEnd('I');
        int shift = s_units.FirstOrDefault(u => number.EndsWith(u.Letter, StringComparison.Ordinal)).Shift;
        bool isNumber = double.TryParse(number.AsSpan(0, number.Length - (shift > 0 ? 1 : 0)), NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double count);
        return isNumber && count > 0 && count * (1L << shift) is >= 1 and <= long.MaxValue / 2.0
            ? (long)(count * (1L << shift))
            : throw new CommandException(ExitStatus.Usage, $"{option} must be an amount such as 512M or 16G, but is {Quotation.Of(size)}");
    }
}
