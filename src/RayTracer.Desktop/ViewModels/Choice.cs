namespace RayTracer.Desktop.ViewModels;

/// <summary>One of several to choose from.</summary>
/// <param name="Value">What is chosen.</param>
/// <param name="Label">How it is shown.</param>
/// <param name="Tip">What it is for; null where the label says it all.</param>
internal sealed record Choice(string Value, string Label, string? Tip = null)
{
    /// <summary>As screen readers read it.</summary>
    public override string ToString() => Label;
}
