using RayTracer.Numerics;

namespace RayTracer.Imaging;

/// <summary>The planes that a denoiser compares, made from two halves of a picture's samples.</summary>
internal sealed class DenoiserInput
{
    private const int VarianceRadius = 2;

    // A half's pixel may be as bright as the brightest of the other half that is at most so far away.
    private const int CutRadius = 3;

    // Differences of features below this share of their range are none (Rousselle, Manzi & Zwicker 2013, τ).
    private const float SmallestFeature = 1e-2f;

    // How many deviations, or steps to the neighbours, two features may differ (the same, k_f).
    private const float FeatureTolerance = 1;

    /// <summary>Compares two halves.</summary>
    public DenoiserInput(HalfPlanes first, HalfPlanes second)
    {
        (int width, int height) = (first.Spread.Width, first.Spread.Height);
        Halves = [first, second];
        Sampled = new(width, height);
        for (int y = 0; y < height; y++)
        {
            for (int x = 0; x < width; x++)
            {
                Sampled[x, y] = first.Counts[x, y] > 0 && second.Counts[x, y] > 0 ? 1 : 0;
            }
        }

        Surfaces = SurfaceColors.Of(Halves);
        Light = [.. Halves.Select(h => h.Color.Select((c, i) => c.With((x, y) => c.Load(x, y) / Surfaces[i].Load(x, y))).ToArray())];
        PaddedPlane squares = ReferenceEquals(first, second) ? OwnSquares(Light[0]) : HalfSquares(Light[0], Light[1], 1);
        squares = squares.Blurred(VarianceRadius);
        Variances = [.. Halves.Select((h, i) => Variance(squares, h.Spread, Halves[i].Counts, Halves[1 - i].Counts))];
        Features = [new(first.Normal, second.Normal), new(first.Albedo, second.Albedo)];
    }

    /// <summary>The halves.</summary>
    public HalfPlanes[] Halves { get; }

    /// <summary>Red, green and blue of each half, divided by <see cref="Surfaces"/>.</summary>
    public PaddedPlane[][] Light { get; }

    /// <summary>Estimated variance of each half's light, summed over the channels.</summary>
    public PaddedPlane[] Variances { get; }

    /// <summary>The colours that the light falls on.</summary>
    public PaddedPlane[] Surfaces { get; }

    /// <summary>1 where both halves have samples, 0 elsewhere and outside the picture.</summary>
    public PaddedPlane Sampled { get; }

    /// <summary>The normals and the albedos.</summary>
    public GuideFeature[] Features { get; }

    /// <summary>The same at half the size.</summary>
    public DenoiserInput Halved()
    {
        HalfPlanes first = Halves[0].Halved();
        return new(first, ReferenceEquals(Halves[0], Halves[1]) ? first : Halves[1].Halved());
    }

    /// <summary>Cuts what stands out of one of two halves alone, and returns the share of the light that was cut.</summary>
    public static double Cut(HalfPlanes first, HalfPlanes second)
    {
        PaddedPlane[] a = [.. first.Color, first.Spread];
        PaddedPlane[] b = [.. second.Color, second.Spread];
        PaddedPlane[] limitsOfA = [.. b.Select(p => p.Largest(CutRadius))];
        PaddedPlane[] limitsOfB = [.. a.Select(p => p.Largest(CutRadius))];
        double cut = 0;
        double all = 0;
        for (int i = 0; i < a.Length; i++)
        {
            double before = a[i].Total() + b[i].Total();
            a[i].Limit(limitsOfA[i]);
            b[i].Limit(limitsOfB[i]);
            bool isLight = i < first.Color.Length;
            all += isLight ? before : 0;
            cut += isLight ? before - a[i].Total() - b[i].Total() : 0;
        }

        return all > 0 ? cut / all : 0;
    }

    private static PaddedPlane HalfSquares(PaddedPlane[] a, PaddedPlane[] b, float factor) => a[0].With((x, y) =>
    {
        FloatW sum = 0f;
        for (int i = 0; i < a.Length; i++)
        {
            FloatW d = a[i].Load(x, y) - b[i].Load(x, y);
            sum = FloatW.MultiplyAdd(d, d, sum);
        }

        return factor * sum;
    });

    // Of one picture alone: what is left where slopes and edges are taken away (Immerkær 1996), and as much again for the half that is not there.
    private static PaddedPlane OwnSquares(PaddedPlane[] light) => light[0].With((x, y) =>
    {
        FloatW sum = 0f;
        foreach (PaddedPlane plane in light)
        {
            FloatW Column(int at) => plane.Load(at, y - 1) - (2f * plane.Load(at, y)) + plane.Load(at, y + 1);
            FloatW residual = Column(x - 1) - (2f * Column(x)) + Column(x + 1);
            sum = FloatW.MultiplyAdd(residual, residual, sum);
        }

        return sum * (1f / 18);
    });

    // The spread of a pixel's samples is known well but too large, for the samples are stratified; a share of the squared difference of the
    // halves, half of it for equal ones, is right but noisy. So the one is scaled by the ratio of their means around the pixel (Rousselle, Knaus & Zwicker 2012,
    // section 4.2).
    private static PaddedPlane Variance(PaddedPlane squares, PaddedPlane spread, PaddedPlane own, PaddedPlane other)
    {
        PaddedPlane around = spread.Blurred(VarianceRadius);
        PaddedPlane near = spread.Blurred(1);
        return spread.With((x, y) =>
        {
            FloatW mean = around.Load(x, y);
            FloatW share = other.Load(x, y) / FloatW.Max(1f, own.Load(x, y) + other.Load(x, y));
            return share * squares.Load(x, y) * (mean > 0f).Select(near.Load(x, y) / mean, 1f);
        });
    }

    /// <summary>A vector that both halves know of each pixel, and how far two of them may be apart.</summary>
    internal sealed class GuideFeature
    {
        /// <summary>Prepares one.</summary>
        /// <param name="first">Its coordinates in one half.</param>
        /// <param name="second">Those in the other half.</param>
        public GuideFeature(PaddedPlane[] first, PaddedPlane[] second)
        {
            Mean = SurfaceColors.Means(first, second);
            Variance = HalfSquares(first, second, 0.25f).Blurred(1);
            Scale = Variance.With((x, y) =>
            {
                FloatW slope = 0f;
                foreach (PaddedPlane plane in Mean)
                {
                    FloatW dx = 0.5f * (plane.Load(x + 1, y) - plane.Load(x - 1, y));
                    FloatW dy = 0.5f * (plane.Load(x, y + 1) - plane.Load(x, y - 1));
                    slope = FloatW.MultiplyAdd(dx, dx, FloatW.MultiplyAdd(dy, dy, slope));
                }

                FloatW wide = FloatW.Max(SmallestFeature, FloatW.Max(Variance.Load(x, y), slope));
                return 1f / (FeatureTolerance * FeatureTolerance * wide);
            });
        }

        /// <summary>Its coordinates.</summary>
        public PaddedPlane[] Mean { get; }

        /// <summary>Their estimated variance, summed.</summary>
        public PaddedPlane Variance { get; }

        /// <summary>The factor of squared differences.</summary>
        public PaddedPlane Scale { get; }
    }
}
