namespace RayTracer.Desktop.ViewModels;

/// <summary>A layer that an OpenEXR file may have.</summary>
/// <param name="Name">How files call it.</param>
/// <param name="Label">What it is called.</param>
internal sealed record LayerChoice(string Name, string Label)
{
    /// <summary>Whether it is wanted.</summary>
    public bool IsOn { get; set; }
}
