using System.Globalization;
using System.Text.Json;

namespace RayTracer.Labs;

/// <summary>Runs the checks of a lab in a process of its own, which may end or hang in any of them: the next check then has another process.</summary>
internal static class CheckProcess
{
    // A lab that hangs in every check would keep a grader waiting.
    private const int MostEnds = 3;

    // Until the runtime has started and the checks are listed, which runs nothing of a student and takes long where a machine is busy.
    private static readonly TimeSpan s_start = TimeSpan.FromMinutes(1);

    // Bytes of managed memory, in hexadecimal digits: 1 GiB.
    private const string HeapLimit = "40000000";

    /// <summary>The environment of a process that runs checks.</summary>
    public static IReadOnlyList<(string Name, string Value)> Environment { get; } = [("DOTNET_GCHeapHardLimit", HeapLimit), ("DOTNET_gcServer", "0"), ("DOTNET_TieredCompilation", "1"), ("DOTNET_EnableDiagnostics", "0"), ("DOTNET_DbgEnableMiniDump", "0")];

    /// <summary>The command that runs the checks from a number on.</summary>
    /// <param name="program">The words that start the command <c>raytracer</c>.</param>
    /// <param name="assembly">The assembly.</param>
    /// <param name="student">The student's name.</param>
    /// <param name="from">How many checks to leave out.</param>
    public static IReadOnlyList<string> Command(IReadOnlyList<string> program, string assembly, string student, int from) =>
        [.. program, "lab", "run", assembly, "--name", student, "--from", from.ToString(CultureInfo.InvariantCulture)];

    /// <summary>Runs all checks.</summary>
    /// <param name="command">Returns the command that runs the checks from a number on.</param>
    /// <param name="limit">How long one check may take.</param>
    /// <exception cref="LabException">They could not be started.</exception>
    public static IReadOnlyList<Finding> Run(Func<int, IReadOnlyList<string>> command, TimeSpan limit)
    {
        List<Finding> findings = [];
        IReadOnlyList<Finding>? checks = null;
        int ends = 0;
        do
        {
            using BoundedProcess process = new(command(findings.Count), Environment);
            DateTime end = DateTime.UtcNow + s_start;
            IReadOnlyList<Finding>? listed = Parse<IReadOnlyList<Finding>>(process.ReadLine(end));
            checks ??= listed ?? throw new LabException($"the checks could not be started: {(process.Finish(end) is null ? "they took too long" : process.FirstError)}");
            for (bool goesOn = true; goesOn && findings.Count < checks.Count;)
            {
                end = DateTime.UtcNow + limit;
                Finding? next = Parse<Finding>(process.ReadLine(end));
                goesOn = next is not null;
                Finding check = checks[findings.Count];
                findings.Add(next is null ? check with { Sentence = Ended(process, end, limit) } : next with { Title = check.Title, Points = check.Points });
            }
        }
        while (findings.Count < checks.Count && ++ends < MostEnds);
        return [.. findings, .. checks.Skip(findings.Count).Select(c => c with { Sentence = $"Not run, as your code had to be ended {MostEnds} times: {findings[^1].Sentence}" })];
    }

    private static string Ended(BoundedProcess process, DateTime end, TimeSpan limit) => process.Finish(end) is null
        ? $"Your code took longer than {limit.TotalSeconds:0} seconds: is there a loop that does not end?"
        : $"Your code ended the program: does a function call itself without end, or take more than a gigabyte? {process.FirstError}".TrimEnd();

    private static T? Parse<T>(string? line)
        where T : class
    {
        try
        {
            return line is null ? null : JsonSerializer.Deserialize<T>(line);
        }
        catch (JsonException)
        {
            return null;
        }
    }
}
