using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// The partial sums of a subpath's weight: over the other ways in which the paths that go through its last vertex could have been made, each way's
/// density over that of the subpath, to the power of the heuristic. They are brought along from vertex to vertex (van Antwerpen 2011; Georgiev, Křivánek,
/// Davidovič &amp; Slusallek 2012, whose names they have), so that the weight of a path takes what its two ends know, and nothing between.
/// </summary>
internal struct SubpathSumsW
{
    /// <summary>What both kinds of ways share: those that make a connection or a merge at the last edge.</summary>
    public FloatW Vcm;

    /// <summary>The ways before, as seen by connections.</summary>
    public FloatW Vc;

    /// <summary>The ways before, as seen by merges.</summary>
    public FloatW Vm;

    // Far from what any sum of use comes to; no infinity may meet a zero.
    private const float Most = 1e30f;

    /// <summary>The sums of a vertex in the measure of area, from those that the ray to it left with.</summary>
    /// <param name="distance2">The squared length of the ray.</param>
    /// <param name="cosine">Cosine between the ray and the surface's normal.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Arrive(FloatW distance2, FloatW cosine)
    {
        FloatW perArea = PathWeights.Power(1f / cosine);
        Vcm = Limited(Vcm * PathWeights.Power(distance2) * perArea);
        Vc = Limited(Vc * perArea);
        Vm = Limited(Vm * perArea);
    }

    /// <summary>The same where media let the ray to the vertex through with a probability: of all ways, only that which connects its two ends lacks this factor.</summary>
    /// <param name="probability">The probability.</param>
    public void Pass(FloatW probability) => Vcm = Limited(Vcm * PathWeights.Power(1f / probability));

    /// <summary>The sums of the ray that leaves a vertex.</summary>
    /// <param name="cosine">Cosine between the ray and the surface's normal.</param>
    /// <param name="pdf">The density, per steradian, with which its direction was chosen.</param>
    /// <param name="reversePdf">The density with which a path that comes back along it would be sent to where this one came from.</param>
    /// <param name="delta">The lanes whose direction was a single one: there, the last vertex is neither connected nor merged.</param>
    /// <param name="weights">The constants of the pass.</param>
    public void Leave(FloatW cosine, FloatW pdf, FloatW reversePdf, MaskW delta, PathWeights weights)
    {
        FloatW through = PathWeights.Power(cosine);
        FloatW perPdf = PathWeights.Power(1f / pdf);
        FloatW back = PathWeights.Power(reversePdf);
        FloatW vc = through * perPdf * FloatW.MultiplyAdd(Vc, back, Vcm + weights.Merging);
        FloatW vm = through * perPdf * FloatW.MultiplyAdd(Vm, back, FloatW.MultiplyAdd(Vcm, weights.Connecting, weights.HasMerges));
        Vc = Limited(delta.Select(Vc * through, vc));
        Vm = Limited(delta.Select(Vm * through, vm));
        Vcm = delta.Select(0f, Limited(perPdf));
    }

    /// <summary>The sum over the ways with a vertex more on the other subpath, for a connection that starts at the last vertex.</summary>
    /// <param name="reversePdf">The density with which a path that comes along the connection would be sent to where this one came from.</param>
    /// <param name="weights">The constants of the pass.</param>
    public readonly FloatW Connected(FloatW reversePdf, PathWeights weights) =>
        FloatW.MultiplyAdd(Vc, PathWeights.Power(reversePdf), Vcm + weights.Merging);

    /// <summary>The sum over the ways with a vertex more on the other subpath, for a merge at the last vertex.</summary>
    /// <param name="pdf">The density with which this subpath's last vertex is left towards where the other came from.</param>
    /// <param name="weights">The constants of the pass.</param>
    public readonly FloatW Merged(FloatW pdf, PathWeights weights) =>
        FloatW.MultiplyAdd(Vm, PathWeights.Power(pdf), Vcm * weights.Connecting);

    /// <summary>A sum that can be multiplied by 0: as large as any of use, also where it is infinite or not a number.</summary>
    public static FloatW Limited(FloatW sum) => (sum < Most).Select(sum, Most);
}

/// <summary>The one heuristic by which all ways to make a path are weighed, and its constants in a pass.</summary>
/// <param name="cameraPaths">The number of camera paths of the pass, one of each pixel.</param>
/// <param name="perLightPath">The number of them for each light path, and for each one that is connected with a light path.</param>
/// <param name="mergeRadius">The greatest distance at which vertices are merged; 0 where none are.</param>
/// <param name="isInMedium">True for vertices in media, which are never merged.</param>
internal sealed class PathWeights(float cameraPaths, int perLightPath, float mergeRadius, bool isInMedium = false)
{
    private readonly PathWeights? _inMedia = isInMedium ? null : new(cameraPaths, perLightPath, mergeRadius, isInMedium: true);

    /// <summary>The light paths of the pass, as often as there is one for each connection: the number of camera paths.</summary>
    public float CameraPaths { get; } = cameraPaths;

    /// <summary>Camera paths for each one that is connected with a light path: all of them ask the lights, or meet them.</summary>
    public float PerLightPath { get; } = perLightPath;

    /// <summary>
    /// How many light paths' vertices a merge takes in, for each connection and each unit of their density: N·πr². 0 where none are merged.
    /// </summary>
    public float Merge { get; } = cameraPaths * float.Pi * mergeRadius * mergeRadius;

    /// <summary>The factor of a merge beside a connection: the power of <see cref="Merge"/>.</summary>
    public float Merging => isInMedium ? 0 : Merge * Merge;

    /// <summary>The factor of a connection beside a merge; 0 where nothing is merged.</summary>
    public float Connecting => Merge > 0 ? 1 / (Merge * Merge) : 0;

    /// <summary>1 where vertices are merged, else 0.</summary>
    public float HasMerges => Merge > 0 && !isInMedium ? 1 : 0;

    /// <summary>The constants at vertices of a group.</summary>
    public PathWeights At(ShadingGroup group) => group.IsOfMedia ? _inMedia! : this;

    /// <summary>The power heuristic's power, 2 (Veach 1997, section 9.2).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Power(FloatW density) => density * density;
}
