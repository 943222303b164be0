using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A sample of the pixel that is looked into.</summary>
internal sealed record SampleRow(InspectedPath Path)
{
    /// <summary>Its number and radiance.</summary>
    public string Text => $"{SessionTexts.Of("paths.sample")} {Path.Sample}   {Radiance}";

    /// <summary>Its radiance in short.</summary>
    public string Radiance => Figures.Color(Path.Radiance);
}
