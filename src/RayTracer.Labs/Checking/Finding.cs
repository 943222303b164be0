namespace RayTracer.Labs;

/// <summary>What one check of a lab found.</summary>
/// <param name="Title">What was checked.</param>
/// <param name="Points">What it is worth.</param>
public sealed record Finding(string Title, int Points)
{
    /// <summary>True where it is right.</summary>
    public bool IsRight { get; init; }

    /// <summary>What is wrong, in a sentence or two; null where all is right.</summary>
    public string? Sentence { get; init; }

    /// <summary>True where the sentence names one of the lab's common mistakes.</summary>
    public bool IsRecognised { get; init; }

    /// <summary>True for a wrong answer of which no mistake is recognised.</summary>
    internal bool IsWrongAnswer => !IsRight && !IsRecognised && Found is not null;

    /// <summary>The smallest case in which it goes wrong; null where there is none.</summary>
    public string? Case { get; init; }

    /// <summary>What was expected in that case.</summary>
    public string? Expected { get; init; }

    /// <summary>What was found instead.</summary>
    public string? Found { get; init; }

    /// <summary>What there is to look at.</summary>
    public IReadOnlyList<Exhibit> Exhibits { get; init; } = [];
}

/// <summary>Something to look at.</summary>
/// <param name="Title">What it is.</param>
/// <param name="Kind">Its format, as the ending of a file: svg, png, or json for a scene.</param>
/// <param name="Content">The file.</param>
public sealed record Exhibit(string Title, string Kind, byte[] Content);

/// <summary>Ends a check with what it found.</summary>
/// <param name="finding">The finding; its title and points are the check's.</param>
public sealed class CheckFailedException(Finding finding) : Exception(finding.Sentence)
{
    /// <summary>The finding.</summary>
    public Finding Finding { get; } = finding;
}

/// <summary>Marks a static method that checks a part of a lab. It takes a <see cref="CheckRun"/>, and returns where all is right.</summary>
/// <param name="title">What is checked.</param>
/// <param name="points">What it is worth.</param>
[AttributeUsage(AttributeTargets.Method)]
public sealed class CheckAttribute(string title, int points) : Attribute
{
    /// <summary>What is checked.</summary>
    public string Title => title;

    /// <summary>What it is worth.</summary>
    public int Points => points;
}
