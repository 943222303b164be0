using RayTracer.Numerics;
using RayTracer.Spectra;

namespace RayTracer.Materials;

/// <summary>
/// A transparent film on a surface, as thin as wavelengths are long: what its two faces reflect interferes (Belcour &amp; Barla 2017, section 4, with the reflectances of the glTF extension
/// KHR_materials_iridescence, Khronos Group 2021). Airy's sum becomes a series in the length of the way through the film, of which each term has a cosine that daylight's colours blur: a table has
/// what is left of it, by channel.
/// </summary>
/// <param name="index">Refractive index of the film over that of the outside, at least 1.</param>
internal sealed unsafe class ThinFilm(float index)
{
    // A lane ends its series at terms as small as this: head-on after two or three, but at grazing angles, where both faces reflect much, after many.
    private const float Little = 5e-4f;
    private const int MostTerms = 24;

    // A base that reflects more has no index.
    private const float Most = 0.9999f;

    // Between the numbers of the table, in nm of the way; beyond them, colours are those without interference.
    private const float Step = 4;
    private const int Steps = 4096;
    private static readonly PinnedBuffer<float> s_cosines = Cosines();

    /// <summary>What the surface reflects with the film.</summary>
    /// <param name="cosine">Cosine of the angle outside of the film, 0 to 1.</param>
    /// <param name="headOn">What the base would reflect head-on without it, 0 to 1.</param>
    /// <param name="thickness">Thickness of the film, in nm.</param>
    public RgbW Reflectance(FloatW cosine, in RgbW headOn, FloatW thickness)
    {
        float jump = (index - 1) / (index + 1);
        FloatW outer = Fresnel.Schlick(cosine, jump * jump);
        FloatW inside = FloatW.Sqrt(1f - (FloatW.NegatedMultiplyAdd(cosine, cosine, 1f) * (1 / (index * index))));
        Bounces red = new(outer, inside, headOn.R, index);
        Bounces green = new(outer, inside, headOn.G, index);
        Bounces blue = new(outer, inside, headOn.B, index);
        for (int term = 1; term <= MostTerms && (red.Goes | green.Goes | blue.Goes).Any; term++)
        {
            RgbW left = Blurred(thickness * inside * (2 * index * term));
            red.Add(left.R);
            green.Add(left.G);
            blue.Add(left.B);
        }

        return new(red.Sum(), green.Sum(), blue.Sum());
    }

    // Daylight's mean of the cosine of the phase after a way in nm, by channel.
    private static RgbW Blurred(FloatW way)
    {
        FloatW place = FloatW.Min(way * (1 / Step), Steps - 1);
        FloatW first = FloatW.Floor(place);
        FloatW part = place - first;
        UIntW at = first.ToIntInRange() * 3u;
        return RgbW.Mix(RgbW.Gather(s_cosines.Pointer, at), RgbW.Gather(s_cosines.Pointer + 3, at), part);
    }

    // The last numbers are 0: so are all beyond.
    private static PinnedBuffer<float> Cosines()
    {
        PinnedBuffer<float> table = new((Steps + 1L) * 3);
        (double R, double G, double B) whole = Daylight(0);
        for (int step = 0; step < Steps - 1; step++)
        {
            (double r, double g, double b) = Daylight(step * Step);
            ReadOnlySpan<float> left = [(float)(r / whole.R), (float)(g / whole.G), (float)(b / whole.B)];
            left.CopyTo(new Span<float>(table.Pointer + (3 * step), 3));
        }

        return table;
    }

    // The colour of daylight times the cosines of its phases after a way.
    private static (double R, double G, double B) Daylight(double way) => CieTables.LinearSrgb(i =>
    {
        double turns = way / (CieTables.First + (i * CieTables.Step));
        LaneMath.SinCosTurn((float)(turns - double.Floor(turns)), out _, out FloatW cosine);
        return CieTables.D65[i] * cosine[0];
    });

    // The series of a channel (Belcour & Barla 2017, eqs. 9 and 10).
    private struct Bounces
    {
        private readonly FloatW _product;
        private readonly FloatW _plain;
        private FloatW _factor;
        private FloatW _interference;

        public Bounces(FloatW outer, FloatW inside, FloatW headOn, float index)
        {
            // The index of the base is that of a dielectric that reflects as much.
            FloatW root = FloatW.Sqrt(FloatW.Max(FloatW.Min(headOn, Most), 0f));
            FloatW below = (1f + root) / (1f - root);
            FloatW jump = (below - index) / (below + index);
            FloatW inner = Fresnel.Schlick(inside, jump * jump);
            FloatW passed = 1f - outer;
            FloatW repeated = passed * passed * inner / FloatW.Max(FloatW.NegatedMultiplyAdd(outer, inner, 1f), 1 - Most);

            // Where light meets a denser medium, its phase turns by half.
            _product = FloatW.CopySign(FloatW.Sqrt(outer * inner), -jump);
            _plain = outer + repeated;
            _factor = (repeated - passed) * 2f;
            _interference = 0f;
        }

        public readonly MaskW Goes => FloatW.Abs(_factor * _product) > Little;

        public void Add(FloatW blurred)
        {
            _factor = Goes.Select(_factor * _product, 0f);
            _interference = FloatW.MultiplyAdd(_factor, blurred, _interference);
        }

        // Of saturated colours, some channels are darker than black.
        public readonly FloatW Sum() => FloatW.Max(0f, FloatW.Min(_plain + _interference, 1f));
    }
}
