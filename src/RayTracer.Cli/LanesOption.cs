using System.CommandLine;
using System.Globalization;
using System.Numerics;
using RayTracer.Jobs;

namespace RayTracer.Cli;

/// <summary>
/// The option <c>--lanes</c> of the verbs that render. It is obeyed before anything else is done, as the program starts again with
/// registers of another width.
/// </summary>
internal static class LanesOption
{
    private const string Name = "--lanes";

    private static readonly string[] s_verbs = ["render", "sweep", "resume", "verify", "bench", "reproduce"];

    // Values of options that may make a render short.
    private static readonly Dictionary<string, int> s_short = new() { ["--width"] = 256, ["--height"] = 256, ["--scale"] = 25, ["--spp"] = 8 };

    /// <summary>Gives a command the option if it is of a verb that renders.</summary>
    public static void AddTo(Command command)
    {
        if (s_verbs.Contains(command.Name))
        {
            Option<string?> option = new(Name) { Description = "Number of light paths that one instruction follows; without it, 16 for long renders where the processor can.", HelpName = "8|16" };
            option.Validators.Add(result =>
            {
                if (result.Tokens is [.., var word] && Complaint(word.Value) is { } complaint)
                {
                    result.AddError(complaint);
                }
            });
            command.Options.Add(option);
        }
    }

    /// <summary>The number of lanes that was asked for; null where none was.</summary>
    public static string? Given(ParseResult result) => result.GetValue<string?>(Name);

    /// <summary>Starts the program again if the words ask for another number of lanes, or it gains by one.</summary>
    /// <param name="args">The words after the program's name.</param>
    public static void Obey(string[] args)
    {
        if (args is not [var verb, ..] || !s_verbs.Contains(verb))
        {
            return;
        }

        int i = Array.LastIndexOf(args, Name);
        string? wanted = i >= 0 && i + 1 < args.Length ? args[i + 1] : Array.FindLast(args, a => a.StartsWith($"{Name}=", StringComparison.Ordinal))?[(Name.Length + 1)..];
        if (wanted is not null)
        {
            if (Complaint(wanted) is null)
            {
                WideVectors.Enable(args, int.Parse(wanted), isLong: verb != "render" || !MayBeShort(args));
            }
        }
        else if (verb == "render" && MayBeShort(args))
        {
            WideVectors.Postpone(args);
        }
        else
        {
            WideVectors.Enable(args);
        }
    }

    // The scene is read before that is known, and read again by a program that starts again.
    private static bool MayBeShort(string[] args) => args.Zip(args[1..]).Any(
        pair => s_short.TryGetValue(pair.First, out int most) && double.TryParse(pair.Second.TrimEnd('%'), CultureInfo.InvariantCulture, out double number) && number <= most);

    private static string? Complaint(string word) => word is not ("8" or "16") ? $"{Name} {word}: 8 or 16 is expected"
        : int.Parse(word) > Math.Max(WideVectors.Widest, Vector<float>.Count) ? $"{Name} {word}: the registers of this processor are narrower, or this system cannot start a program again"
        : null;
}
