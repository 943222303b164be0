namespace RayTracer.Desktop.ViewModels;

/// <summary>One of several to choose from.</summary>
/// <param name="Value">The value that is chosen.</param>
/// <param name="Label">The label.</param>
/// <param name="Tip">Its purpose; null where the label says it all.</param>
internal sealed record Choice(string Value, string Label, string? Tip = null)
{
    /// <summary>As screen readers read it.</summary>
    public override string ToString() => Label;
}
