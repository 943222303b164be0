namespace RayTracer.Labs;

/// <summary>What came of checking a student's folder.</summary>
/// <param name="Card">Which lab it is, and whose.</param>
/// <param name="Errors">What the compiler refused; empty where it compiles.</param>
/// <param name="Findings">What the checks found.</param>
public sealed record LabCheck(LabCard Card, IReadOnlyList<string> Errors, IReadOnlyList<Finding> Findings)
{
    /// <summary>How long a check may take, unless another limit is given.</summary>
    public static TimeSpan Limit { get; } = TimeSpan.FromSeconds(20);

    /// <summary>The points that were reached.</summary>
    public int Points => Findings.Where(f => f.IsRight).Sum(f => f.Points);

    /// <summary>The points that there are; 0 where it does not compile.</summary>
    public int Most => Findings.Sum(f => f.Points);

    /// <summary>True where all is right.</summary>
    public bool IsRight => Errors.Count == 0 && Findings.All(f => f.IsRight);

    /// <summary>Compiles the folder of a student, and runs the checks of its lab.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="program">The words that start the command <c>raytracer</c>.</param>
    /// <param name="limit">How long one check may take.</param>
    /// <param name="sandbox">In what to run all that; null for nothing.</param>
    /// <exception cref="LabException">It cannot be checked.</exception>
    internal static LabCheck Run(LabFolder folder, IReadOnlyList<string> program, TimeSpan limit, Sandbox? sandbox = null)
    {
        DirectoryInfo work = Directory.CreateTempSubdirectory("raytracer-lab-");
        try
        {
            (string assembly, IReadOnlyList<string> errors) = folder.Compile(work.FullName, command => sandbox?.Writing(work.FullName, folder.Path, command) ?? command);
            return new(folder.Card, errors, errors.Count > 0 ? [] : WithAdvice(CheckProcess.Run(
                from => CheckProcess.Command(program, assembly, folder.Card.Name, from) is var command && sandbox is not null ? sandbox.Reading(work.FullName, command) : command, limit)));
        }
        finally
        {
            work.Delete(recursive: true);
        }
    }

    // Later checks use what earlier ones are of: what is wrong without being recognised may be the same fault again.
    private static IReadOnlyList<Finding> WithAdvice(IReadOnlyList<Finding> findings) =>
    [
        .. findings.Select((f, i) => f.IsWrongAnswer && findings.Take(i).Any(earlier => !earlier.IsRight)
            ? f with { Sentence = $"{f.Sentence} It may come from what is wrong above: mend that first." } : f),
    ];
}
