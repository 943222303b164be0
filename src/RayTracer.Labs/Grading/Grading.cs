namespace RayTracer.Labs;

/// <summary>What one hand-in is worth.</summary>
/// <param name="Source">The name of its file or folder.</param>
/// <param name="Check">What was found; null where it could not be checked.</param>
/// <param name="Note">What a teacher should know besides: why it could not be checked, or that it has been changed; null for nothing.</param>
internal sealed record Mark(string Source, LabCheck? Check, string? Note)
{
    /// <summary>The first error of the compiler, or else the note; null for neither.</summary>
    public string? Problem => Check?.Errors is [var error, ..] ? error : Note;

    /// <summary>A line of a list of marks.</summary>
    public string Line
    {
        get
        {
            string note = Check?.Errors is [var error, ..] ? $"does not compile: {error}" : Note ?? "";
            return Check is null ? $"{Source}: {note}" : $"{Source}: {Check.Card.Name}, lab {Check.Card.Lab}: {Check.Points} of {Check.Most} points{(note.Length > 0 ? $" ({note})" : "")}";
        }
    }
}

/// <summary>Checks all hand-ins of a folder. They are not trusted: of each, nothing but C# is taken, which is compiled and run in a sandbox.</summary>
internal sealed class Grading
{
    private readonly IReadOnlyList<string> _program;
    private readonly TimeSpan _limit;
    private readonly Sandbox? _sandbox;

    /// <summary>Prepares for it.</summary>
    /// <param name="program">The words that start the command <c>raytracer</c>.</param>
    /// <param name="limit">How long one check may take.</param>
    /// <param name="isTrusting">True to do without a sandbox.</param>
    /// <exception cref="LabException">There is no sandbox here.</exception>
    public Grading(IReadOnlyList<string> program, TimeSpan limit, bool isTrusting)
    {
        (_program, _limit) = (program, limit);
        if (!isTrusting)
        {
            _sandbox = Sandbox.Obstacle() is { } obstacle
                ? throw new LabException($"hand-ins are programs of others, and are run in a sandbox only: {obstacle}; --trust runs them without one")
                : new Sandbox(Compiler.DotNet, AppContext.BaseDirectory);
        }
    }

    /// <summary>Grades.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="done">Receives each mark.</param>
    /// <param name="cancellation">Ends it before the next hand-in.</param>
    /// <exception cref="LabException">There is nothing in it.</exception>
    public IReadOnlyList<Mark> Run(string folder, Action<Mark> done, CancellationToken cancellation)
    {
        string[] sources =
        [
            .. new DirectoryInfo(folder).EnumerateFileSystemInfos().Where(f => f is DirectoryInfo || f.Extension.Equals(".zip", StringComparison.OrdinalIgnoreCase))
                .Select(f => f.FullName).Order(StringComparer.Ordinal),
        ];
        if (sources.Length == 0)
        {
            throw new LabException($"there are no hand-ins in '{folder}': files that \"raytracer lab hand-in\" makes, or folders");
        }

        List<Mark> marks = [];
        foreach (string source in sources.TakeWhile(_ => !cancellation.IsCancellationRequested))
        {
            marks.Add(Grade(source));
            done(marks[^1]);
        }

        return marks;
    }

    private Mark Grade(string source)
    {
        DirectoryInfo own = Directory.CreateTempSubdirectory("raytracer-grade-");
        try
        {
            (LabFolder folder, bool isAsHandedIn) = HandIn.Unpack(source, own.FullName);
            return new(Path.GetFileName(source), LabCheck.Run(folder, _program, _limit, _sandbox), isAsHandedIn ? null : "the sources are not those that the hand-in was made of");
        }
        catch (Exception e) when (e is LabException or IOException or UnauthorizedAccessException)
        {
            return new(Path.GetFileName(source), null, e.Message.ReplaceLineEndings(" "));
        }
        finally
        {
            own.Delete(recursive: true);
        }
    }
}
