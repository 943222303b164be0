using System.Numerics;
using RayTracer.Description;

namespace RayTracer.Rendering;

/// <summary>
/// Exact sums that a film holds of each pixel beside those of its picture, by a name that files give them too. They are added as those are:
/// in any order, with the same bits.
/// </summary>
public sealed class FilmPlane
{
    // Halves are blocks of so many samples at most: 2 to the power of it.
    private const int LargestBlock = 6;

    private FilmPlane(string name, IReadOnlyList<string> sums)
    {
        Name = name;
        Sums = sums;
    }

    /// <summary>
    /// One half of the samples: their red, green and blue, their squared luminance and their number, in the film's units. The first half
    /// and the second take turns, in blocks that grow with the samples' numbers to 64: so each is spread over pixel, lens and lights as a
    /// picture of half as many samples would be.
    /// </summary>
    public static FilmPlane Half { get; } = new("half", ["red", "green", "blue", "square", "count"]);

    /// <summary>
    /// What the paths from the lights bring to a pixel (<see cref="SplatSums"/>), in the film's units, and the number of light samples, each of
    /// which is all light paths of one sample number.
    /// </summary>
    internal static FilmPlane Light { get; } = new("light", ["red", "green", "blue", "count"]);

    /// <summary>
    /// The squared luminance of each light sample of the pixel, in units of 2⁻⁴⁸: from it follows how noisy the light is. Files keep it only
    /// beside <see cref="LightHalf"/>.
    /// </summary>
    internal static FilmPlane LightSquare { get; } = new("lightSquare", ["square"]);

    /// <summary>The light samples of the half that <see cref="Half"/> has, for films with that and <see cref="LightSquare"/>.</summary>
    internal static FilmPlane LightHalf { get; } = new("lightHalf", Half.Sums);

    /// <summary>
    /// What is behind everything (<see cref="Backdrop"/>): the share of the samples that see it, and its red, green and blue, in the film's
    /// units, times the pixel filter's weights.
    /// </summary>
    internal static FilmPlane Alpha { get; } = new("alpha", ["through", "red", "green", "blue"]);

    /// <summary>
    /// What <see cref="Alpha"/> leaves out because it stands for things of a photograph (<see cref="Materials.MatteRole"/>): the share of the samples that see a
    /// shadow catcher, its light, and its light in the scene without the things that throw shadows, both of the same samples.
    /// </summary>
    internal static FilmPlane Matte { get; } = new("matte", ["caught", "red", "green", "blue", "redAlone", "greenAlone", "blueAlone"]);

    /// <summary>All that this version of the program knows.</summary>
    public static IReadOnlyList<FilmPlane> Known { get; } = [Half, Light, LightSquare, LightHalf, Alpha, Matte];

    /// <summary>Those that camera samples add to, beside their light.</summary>
    internal static IReadOnlyList<FilmPlane> OfSamples { get; } = [Alpha, Matte];

    /// <summary>Its index in <see cref="OfSamples"/>.</summary>
    internal int IndexOfSamples => this == Alpha ? 0 : 1;

    /// <summary>Returns the planes that a film needs.</summary>
    /// <param name="integrator">The integrator of its light.</param>
    /// <param name="halves">True if it keeps two halves of its samples.</param>
    /// <param name="noise">True if the noise of its pixels is wanted (<see cref="Film.MeanVariance"/>).</param>
    /// <param name="alpha">True if it shall know what is behind everything.</param>
    /// <param name="matte">True if it shall know what stands for things of a photograph.</param>
    internal static IReadOnlyList<FilmPlane> Needed(Integrator integrator, bool halves = false, bool noise = false, bool alpha = false, bool matte = false)
    {
        bool hasLight = integrator.Has(IntegratorTraits.TracesLight);
        (FilmPlane Plane, bool IsNeeded)[] all =
        [
            (Half, halves), (Light, hasLight), (LightSquare, hasLight && (noise || halves)), (LightHalf, hasLight && halves), (Alpha, alpha), (Matte, matte),
        ];
        return [.. all.Where(p => p.IsNeeded).Select(p => p.Plane)];
    }

    /// <summary>The name.</summary>
    public string Name { get; }

    /// <summary>The names of the sums of each pixel, in their order.</summary>
    public IReadOnlyList<string> Sums { get; }

    /// <summary>True if this version of the program knows it, and so what samples add to it.</summary>
    public bool IsKnown => Known.Contains(this);

    /// <summary>Returns the plane that a file speaks of, which may be unknown.</summary>
    /// <param name="name">Its name.</param>
    /// <param name="sums">The names of its sums.</param>
    public static FilmPlane Of(string name, IReadOnlyList<string> sums) =>
        Known.FirstOrDefault(p => p.Name == name && p.Sums.SequenceEqual(sums)) ?? new(name, sums);

    /// <summary>Returns whether a sample is one of <see cref="Half"/>.</summary>
    /// <param name="sample">Its number in the whole picture, from 0.</param>
    public static bool IsOfHalf(int sample)
    {
        int block = sample < 2 ? 0 : Math.Min(LargestBlock, BitOperations.Log2((uint)sample) - 1);
        return (sample >> block & 1) == 0;
    }

    /// <summary>The first sample after some others whose half is another than theirs.</summary>
    /// <param name="first">The first of them.</param>
    internal static int EndOfTurn(int first)
    {
        int end = first + 1;
        while (IsOfHalf(end) == IsOfHalf(first))
        {
            end++;
        }

        return end;
    }

    /// <inheritdoc/>
    public override string ToString() => Name;
}
