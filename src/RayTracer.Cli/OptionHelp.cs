namespace RayTracer.Cli;

/// <summary>An option of a verb, as help pages and shells see it.</summary>
/// <param name="Names">How it is written: the long name first.</param>
/// <param name="Form">What its value looks like; null where it has none.</param>
/// <param name="Summary">What it means.</param>
/// <param name="IsRepeatable">Whether it may be given several times.</param>
internal sealed record OptionHelp(IReadOnlyList<string> Names, string? Form, string Summary, bool IsRepeatable)
{
    /// <summary>The words that its value is one of; empty where it is something else.</summary>
    public IReadOnlyList<string> Choices { get; } = Form is not null && Form.Contains('|', StringComparison.Ordinal) ? Form.Split('|') : [];

    /// <summary>Whether its value is the name of a file or folder.</summary>
    public bool TakesFile => Form is "FILE" or "SCENE" or "FOLDER" or "IMAGE";
}
