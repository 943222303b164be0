using RayTracer.Numerics;

namespace RayTracer.Materials;

/// <summary>
/// What comes out of a coat over metal after it has gone back and forth between the two as often as it takes: by numerical integration over the microfacets of both, in the
/// cosine alone (the sum of all orders by adding layers: Jakob et al., A comprehensive framework for rendering layered materials, 2014, section 3). It is shared out between
/// light that is reflected by the metal once, which has the metal's lobe, and a rest that goes in all directions.
/// </summary>
internal sealed unsafe class CoatBounces
{
    private const int Angles = 64;
    private const int Side = 32;

    // Of what is left inside, each bounce lets at least some 40 % out or takes it.
    private const int Bounces = 32;
    private readonly PinnedBuffer<float> _memory = new(6 * (Angles + 1));
    private readonly float* _table;
    private readonly ConductorFresnel _metal;
    private readonly ClearCoat _coat;

    /// <summary>Integrates.</summary>
    /// <param name="metal">The metal's reflectance, inside the coat.</param>
    /// <param name="alpha">Roughness of the metal.</param>
    /// <param name="seenAlpha">Its roughness as it is seen through the coat.</param>
    /// <param name="coat">The coat.</param>
    public CoatBounces(ConductorFresnel metal, float alpha, float seenAlpha, ClearCoat coat)
    {
        (_metal, _coat) = (metal, coat);
        _table = _memory.Pointer;
        Microfacets coatFacets = coat.Facets;
        bool isMirror = ClearCoat.IsSmooth(alpha) && !coat.IsRough;
        CoatRow[] inside = [.. Enumerable.Range(0, Angles).Select(i => OfCoat(coatFacets, Cosine(i), coat.Index))];
        CoatRow[] outside = [.. Enumerable.Range(0, Angles + 1).Select(i => OfCoat(coatFacets, Node(i), 1 / coat.Index))];
        double[][] bounced = [.. Enumerable.Range(0, Angles).Select(i => OfMetal(alpha, Cosine(i)))];
        double[][] seen = [.. Enumerable.Range(0, Angles + 1).Select(i => OfMetal(seenAlpha, Bent(Node(i))))];
        float[] rest = new float[3];
        for (int channel = 0; channel < 3; channel++)
        {
            double[] kept = [.. Enumerable.Range(0, Angles).Select(i => Kept(Cosine(i), channel))];
            double[] left = Left(inside, bounced, kept, channel);
            for (int i = 0; i <= Angles; i++)
            {
                double all = outside[i].Transmitted.Zip(left, (into, comes) => into * comes).Sum();
                double once = Lobe(i, seen[i], kept, channel, _ => 1);
                _metal.Evaluate(Bent(Node(i)), out RgbW color);
                double keptOnce = Kept(Bent(Node(i)), channel);
                double mirrored = Channel(color, channel) * (1 - Into(Node(i))) * keptOnce * keptOnce;
                _table[(6 * i) + channel] = (float)(1 - (all > 0 && !isMirror ? double.Max(1 - mirrored, once / all) : 1 - mirrored));
                _table[(6 * i) + 3 + channel] = (float)all;
            }

            for (int i = 0; i <= Angles; i++)
            {
                // Where the lobes bring more already, nothing is taken back.
                double brought = Lobe(i, seen[i], kept, channel, cosine => double.Sqrt(Factor(Node(i), channel) * Factor(cosine, channel)));
                _table[(6 * i) + 3 + channel] = (float)double.Max(_table[(6 * i) + 3 + channel] - brought, 0);
                rest[channel] += 2 * _table[(6 * i) + 3 + channel] * Node(i) / Angles;
            }
        }

        Spread = new(OverPi(rest[0]), OverPi(rest[1]), OverPi(rest[2]));
    }

    /// <summary>The rest's BRDF is this times that of <see cref="At"/> for both directions.</summary>
    public Rgb Spread { get; }

    /// <summary>What comes out for light at an angle.</summary>
    /// <param name="cosine">Cosine of the ray outside, 0 to 1.</param>
    /// <param name="factor">How much more it is, in the directions of light that the metal reflects once, than that alone.</param>
    /// <param name="rest">The fraction of all light that comes out in other directions.</param>
    public void At(in FloatW cosine, out RgbW factor, out RgbW rest)
    {
        FloatW place = FloatW.Max(0f, FloatW.Min(cosine, 1f)) * Angles;
        FloatW left = FloatW.Min(FloatW.Floor(place), Angles - 1);
        UIntW index = left.ToIntInRange() * 6u;
        FloatW t = place - left;

        // The factor itself is steep near the horizon.
        RgbW again = RgbW.Mix(RgbW.Gather(_table, index), RgbW.Gather(_table + 6, index), t);
        factor = new(1f / (1f - again.R), 1f / (1f - again.G), 1f / (1f - again.B));
        rest = RgbW.Mix(RgbW.Gather(_table + 3, index), RgbW.Gather(_table + 9, index), t);
    }

    private static float OverPi(float mean) => mean > 0 ? 1 / (float.Pi * mean) : 0;

    private static float Cosine(int i) => (i + 0.5f) / Angles;

    private static float Node(int i) => float.Max(i / (float)Angles, 1e-3f);

    private static int Bin(float cosine) => int.Clamp((int)(cosine * Angles), 0, Angles - 1);

    private static float Channel(in RgbW color, int channel) => channel == 0 ? color.R[0] : channel == 1 ? color.G[0] : color.B[0];

    // Of light that has come down through the coat at an angle, what gets out at last.
    private static double[] Left(CoatRow[] inside, double[][] bounced, double[] kept, int channel)
    {
        double[] left = new double[Angles];
        for (int bounce = 0; bounce < Bounces; bounce++)
        {
            double[] up = [.. inside.Select(row => row.Transmitted.Sum() + row.Reflected.Zip(left, (back, comes) => back * comes).Sum())];
            left = [.. Enumerable.Range(0, Angles).Select(i => kept[i] * Enumerable.Range(0, Angles).Sum(k => bounced[i][(3 * k) + channel] * kept[k] * up[k]))];
        }

        return left;
    }

    private double Factor(float cosine, int channel)
    {
        At(cosine, out RgbW factor, out _);
        return Channel(factor, channel);
    }

    private double Kept(float cosine, int channel) =>
        LaneMath.Exp(-(channel == 0 ? _coat.Absorption.R : channel == 1 ? _coat.Absorption.G : _coat.Absorption.B) / cosine);

    private float Bent(float cosine)
    {
        Fresnel.Dielectric(cosine, 1 / _coat.Index, out FloatW inside);
        return inside[0];
    }

    private float Into(float cosine) => _coat.Into(cosine, out _)[0];

    // The light that the metal reflects once, as its BRDF has it.
    private double Lobe(int i, double[] row, double[] kept, int channel, Func<float, double> factor)
    {
        double sum = 0;
        for (int k = 0; k < Angles; k++)
        {
            float sine2 = (1 - (Cosine(k) * Cosine(k))) * _coat.Index * _coat.Index;
            if (sine2 < 1)
            {
                float cosine = float.Sqrt(1 - sine2);
                sum += row[(3 * k) + channel] * kept[k] * Into(cosine) * factor(cosine);
            }
        }

        return sum * Into(Node(i)) * Kept(Bent(Node(i)), channel);
    }

    // What the metal reflects of light at a cosine, by the cosine at which it leaves and by channel.
    private double[] OfMetal(float alpha, float cosine)
    {
        double[] row = new double[3 * Angles];
        Microfacets facets = new(MicrofacetDistribution.Ggx, alpha, alpha);
        ForFacets(facets, cosine, (in Vec3W view, in Vec3W normal, in FloatW incident) =>
        {
            Vec3W light = Vec3W.MultiplyAdd(normal, incident * 2f, -view);
            _metal.Evaluate(incident, out RgbW color);
            color *= (light.Z > 0f).Select(Seen(facets, view, light, normal), 0f);

            // Lane by lane, so that the sum is the same at every width.
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                int bin = 3 * Bin(light.Z[lane]);
                (row[bin], row[bin + 1], row[bin + 2]) = (row[bin] + color.R[lane], row[bin + 1] + color.G[lane], row[bin + 2] + color.B[lane]);
            }
        });
        return row;
    }

    // What the coat reflects and lets through, by the cosines at which it leaves.
    private static CoatRow OfCoat(Microfacets facets, float cosine, float eta)
    {
        CoatRow row = new(new double[Angles], new double[Angles]);
        ForFacets(facets, cosine, (in Vec3W view, in Vec3W normal, in FloatW incident) =>
        {
            FloatW fresnel = Fresnel.Dielectric(incident, eta, out FloatW transmitted);
            Vec3W mirrored = Vec3W.MultiplyAdd(normal, incident * 2f, -view);
            Vec3W bent = Vec3W.MultiplyAdd(normal, FloatW.MultiplyAdd(eta, incident, -transmitted), -view * eta);
            FloatW above = (mirrored.Z > 0f).Select(fresnel * Seen(facets, view, mirrored, normal), 0f);
            FloatW below = (bent.Z < 0f).Select((1f - fresnel) * Seen(facets, view, bent, normal), 0f);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                row.Reflected[Bin(mirrored.Z[lane])] += above[lane];
                row.Transmitted[Bin(-bent.Z[lane])] += below[lane];
            }
        });
        return row;
    }

    private static void ForFacets(in Microfacets facets, float cosine, OnFacet meet)
    {
        Vec3W view = new(float.Sqrt(float.Max(1 - (cosine * cosine), 0)), 0f, cosine);
        for (int cell = 0; cell < Side * Side; cell += FloatW.Count)
        {
            UIntW at = UIntW.Iota + (uint)cell;
            FloatW u = ((at & (Side - 1)).ToFloat() + 0.5f) * (1f / Side);
            FloatW v = ((at >> 5).ToFloat() + 0.5f) * (1f / Side);
            Vec3W normal = facets.Sample(view, u, v);
            meet(view, normal, FloatW.Max(0f, FloatW.Min(Vec3W.Dot(view, normal), 1f)));
        }
    }

    // Of facets that are seen from one direction, those that are seen from the other, too, with heights that go together (Heitz 2014, eq. 99); over all cells.
    private static FloatW Seen(in Microfacets facets, in Vec3W view, in Vec3W other, in Vec3W normal)
    {
        FloatW one = facets.Masking(view, normal);
        FloatW two = facets.Masking(other, normal);
        return (two > 0f).Select(two / (two + one - one * two), 0f) * (1f / (Side * Side));
    }

    private delegate void OnFacet(in Vec3W view, in Vec3W normal, in FloatW incident);

    private readonly record struct CoatRow(double[] Reflected, double[] Transmitted);
}
