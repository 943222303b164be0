using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Session;

/// <summary>A vertex of a light path, for people.</summary>
/// <param name="Event">"camera", "diffuse", "specular", "emission" (it ends on what shines), "absorbed", "end" (it is given up) or
/// "miss".</param>
/// <param name="Position">Where; for a miss, a point on the way out.</param>
/// <param name="Normal">The normal, on the ray's side; null where there is none.</param>
/// <param name="Pointer">The thing in the text; null where there is none.</param>
/// <param name="Name">What the thing is called.</param>
/// <param name="Material">What its material is called.</param>
/// <param name="Weight">What throughput is multiplied by: BSDF · cosine / pdf of the chosen direction.</param>
/// <param name="Throughput">What light from here is multiplied by.</param>
/// <param name="Pdf">The density with which the direction was chosen, in 1/sr; null for mirror-like lobes, and where there is none.</param>
/// <param name="Contribution">What the path gathers here; these add up to its radiance without rounding.</param>
/// <param name="Parts">What that consists of.</param>
public sealed record InspectedVertex(
    string Event, Vector3 Position, Vector3? Normal, string? Pointer, string Name, string Material, Rgb Weight, Rgb Throughput, float? Pdf,
    IReadOnlyList<double> Contribution, ContributionParts Parts);
