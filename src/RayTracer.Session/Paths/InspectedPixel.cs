using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>The paths whose light came to a pixel.</summary>
/// <param name="X">Column.</param>
/// <param name="Y">Row.</param>
/// <param name="Pixel">The mean of all samples rendered so far; null where there are none.</param>
/// <param name="Rendered">The number of these samples.</param>
/// <param name="Total">The number of samples that the picture will have.</param>
/// <param name="Samples">Some of its paths.</param>
public sealed record InspectedPixel(int X, int Y, Rgb? Pixel, int Rendered, int Total, IReadOnlyList<InspectedPath> Samples);

/// <summary>A light path, for people.</summary>
/// <param name="Sample">The sample's number in its pixel.</param>
/// <param name="Radiance">The radiance that it brings.</param>
/// <param name="Vertices">From the camera to its end.</param>
/// <param name="Ways">The ways in which light came, where it is traced too; the brightest first.</param>
/// <param name="Sentence">What happened, in one sentence or two; names of things stand between asterisks.</param>
public sealed record InspectedPath(int Sample, Rgb Radiance, IReadOnlyList<InspectedVertex> Vertices, IReadOnlyList<InspectedWay> Ways, string Sentence);

/// <summary>A path from a light to the camera, made of a part of each, for people.</summary>
/// <param name="LightVertices">The vertices from the light, that on the light included.</param>
/// <param name="CameraVertices">The vertices from the camera, that on the lens included.</param>
/// <param name="Event">"met" (the camera's path meets the light), "asked" (it asks the light), "seen" (the light's path is connected with the
/// lens), "connected" or "merged".</param>
/// <param name="Radiance">The radiance that it brings to the pixel.</param>
/// <param name="Weight">The factor on it, for other ways make such paths too.</param>
/// <param name="Things">Names of what the part from the light meets.</param>
/// <param name="Points">From where both parts are joined back to the light.</param>
public sealed record InspectedWay(
    int LightVertices, int CameraVertices, string Event, Rgb Radiance, float Weight, IReadOnlyList<string> Things, IReadOnlyList<Vector3> Points)
{
    /// <summary>The name of the light; empty where it is not known.</summary>
    public string Light { get; init; } = "";

    /// <summary>The factors whose product, with the weight, is the radiance; none where they are not known.</summary>
    public IReadOnlyList<InspectedFactor> Factors { get; init; } = [];
}

/// <summary>A factor of the light that a way brings, for people.</summary>
/// <param name="Kind">What it is.</param>
/// <param name="Value">Its value; numbers are the same in all channels.</param>
/// <param name="Divides">True if the light is divided by it.</param>
public sealed record InspectedFactor(WayFactor Kind, Rgb Value, bool Divides);

/// <summary>A vertex of a light path, for people.</summary>
/// <param name="Event">"camera", "diffuse", "specular", "emission" (it ends on what shines), "absorbed", "end" (it is given up) or
/// "miss".</param>
/// <param name="Position">The position; for a miss, a point on the way out.</param>
/// <param name="Normal">The normal, on the ray's side; null where there is none.</param>
/// <param name="Pointer">The thing in the text; null where there is none.</param>
/// <param name="Name">The name of the thing.</param>
/// <param name="Material">The name of its material.</param>
/// <param name="Weight">The factor on the throughput: BSDF · cosine / pdf of the chosen direction.</param>
/// <param name="Throughput">The factor on light from here.</param>
/// <param name="Pdf">The density with which the direction was chosen, in 1/sr; null for mirror-like lobes, and where there is none.</param>
/// <param name="Contribution">The light that the path gathers here; these add up to its radiance without rounding.</param>
/// <param name="Parts">The parts of that light.</param>
public sealed record InspectedVertex(
    string Event, Vector3 Position, Vector3? Normal, string? Pointer, string Name, string Material, Rgb Weight, Rgb Throughput, float? Pdf,
    IReadOnlyList<double> Contribution, ContributionParts Parts)
{
    /// <summary>The BSDF for the chosen direction, where the weight is this · cosine / pdf; else null.</summary>
    public Rgb? Bsdf { get; init; }

    /// <summary>The cosine between the chosen direction and the normal.</summary>
    public float Cosine { get; init; }

    /// <summary>The probability with which the path survived; the throughput is divided by it.</summary>
    public float Survival { get; init; } = 1;

    /// <summary>The reason for its end: "depth", "roulette", "dark", "leaks", or nothing.</summary>
    public string End { get; init; } = "";

    /// <summary>What media on the way here have left of the throughput.</summary>
    public Rgb Passed { get; init; } = Rgb.White;

    /// <summary>The colour of the wavelength that the path gets here.</summary>
    public Rgb Dispersion { get; init; } = Rgb.White;

    /// <summary>The light that is met; null where nothing shines.</summary>
    public InspectedEmission? Emission { get; init; }

    /// <summary>The points of lights that are asked.</summary>
    public IReadOnlyList<InspectedLight> Lights { get; init; } = [];
}

/// <summary>Light that a path meets, for people.</summary>
/// <param name="Name">The name of the light.</param>
/// <param name="Radiance">The radiance that it sends.</param>
/// <param name="ScatterPdf">The density with which the direction was chosen; null where nothing else finds this light.</param>
/// <param name="LightPdf">The density with which the vertex before asks for this direction.</param>
/// <param name="Weight">The share of meeting it; 0 where it has been counted before.</param>
public sealed record InspectedEmission(string Name, Rgb Radiance, float? ScatterPdf, float? LightPdf, float Weight)
{
    /// <summary>True if the vertex before asks for this light too, or need not.</summary>
    public bool IsFoundOtherwise { get; init; }
}

/// <summary>A point of a light that is asked, for people. It adds throughput · radiance · BSDF · cosine · transmittance · weight / pdf.</summary>
/// <param name="Name">The name of the light.</param>
/// <param name="Pointer">The light in the text; null where it is not there.</param>
/// <param name="Outcome">"arrives", "unlit", "outsideCone", "outsidePicture", "behind", "leaks", "notScattered" or "blocked".</param>
/// <param name="Blocker">The name of what is in the way; null where nothing is, or it is not known.</param>
/// <param name="BlockerPointer">That in the text.</param>
/// <param name="Radiance">The radiance that it sends; of lights without extent, the irradiance.</param>
/// <param name="Pdf">The density of the point, with the probability of the light.</param>
/// <param name="ScatterPdf">The density with which scattering chooses the direction; null where that finds no light.</param>
/// <param name="Bsdf">The BSDF, or a medium's phase function.</param>
/// <param name="Cosine">The cosine to the normal.</param>
/// <param name="Weight">The share of asking.</param>
/// <param name="Transmittance">What is left of the light on the way.</param>
/// <param name="Contribution">The light that it adds.</param>
/// <param name="Point">The point; on the way to it, where it is far away.</param>
public sealed record InspectedLight(
    string Name, string? Pointer, string Outcome, string? Blocker, string? BlockerPointer, Rgb Radiance, float Pdf, float? ScatterPdf, Rgb Bsdf, float Cosine,
    float Weight, Rgb Transmittance, Rgb Contribution, Vector3? Point);

/// <summary>The light that a path gathers at a vertex; red, green and blue each.</summary>
/// <param name="Emitted">The surface's own light, or the background's.</param>
/// <param name="Ambient">Ambient light.</param>
/// <param name="Direct">Light that comes from the sources, along any way where light is traced too.</param>
public sealed record ContributionParts(IReadOnlyList<double> Emitted, IReadOnlyList<double> Ambient, IReadOnlyList<double> Direct);
