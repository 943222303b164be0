using System.Globalization;
using System.Numerics;
using System.Runtime.InteropServices;

namespace RayTracer.Jobs;

/// <summary>The machine that something is measured on, and the day: without them a figure says nothing.</summary>
/// <param name="Processor">The processor's name and class.</param>
/// <param name="Load">The number of programs that wanted a processor, on average over the minute before the measurement.</param>
public sealed record Machine(string Processor, string Load)
{
    private const string Unknown = "unknown";

    /// <summary>The names and values of everything there is to say.</summary>
    public IReadOnlyList<(string Name, string Value)> Rows { get; } =
    [
        ("Date", DateTime.UtcNow.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture)),
        ("Processor", Processor),
        ("Processors", $"{Environment.ProcessorCount}"),
        ("Load before", Load),
        ("Vector lanes", $"{Vector<float>.Count}"),
        ("Architecture", $"{RuntimeInformation.ProcessArchitecture}"),
        ("System", RuntimeInformation.OSDescription),
        ("Runtime", RuntimeInformation.FrameworkDescription),
        ("Program", ProgramName.Text),
    ];

    /// <summary>Describes this machine, as busy as it is now.</summary>
    public static Machine Now() => new(
        Text("/proc/cpuinfo") is { } processors ? NameIn(processors) : Environment.GetEnvironmentVariable("PROCESSOR_IDENTIFIER") ?? Unknown,
        Text("/proc/loadavg")?.Split(' ')[0] ?? Unknown);

    /// <summary>Returns the processor's name and class, as Linux describes its processors.</summary>
    public static string NameIn(string processors)
    {
        ILookup<string, string> values = processors.Split('\n').Select(line => line.Split(':', 2, StringSplitOptions.TrimEntries))
            .Where(part => part.Length == 2).ToLookup(part => part[0], part => part[1]);
        string name = values["model name"].FirstOrDefault(Unknown);
        return values["cpu family"].FirstOrDefault() is { } family ? $"{name}, family {family}, model {values["model"].FirstOrDefault()}" : name;
    }

    /// <inheritdoc/>
    public override string ToString() => string.Join("; ", Rows.Select(r => $"{r.Name.ToLowerInvariant()}: {r.Value}"));

    private static string? Text(string path) => File.Exists(path) ? File.ReadAllText(path) : null;
}
