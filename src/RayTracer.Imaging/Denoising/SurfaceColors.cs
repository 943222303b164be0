using RayTracer.Numerics;

namespace RayTracer.Imaging;

/// <summary>
/// The factors that a picture is divided by before it is filtered, so that textures need not be compared: the albedo, but only as far as
/// the colours around follow it. Where they do not (mirrors, lamps, leaves against each other), or where the albedo itself is noise, the
/// factor is its mean over the surroundings, which takes nothing away.
/// </summary>
internal static class SurfaceColors
{
    private const int Radius = 3;

    // What darker surfaces are divided by: most of their light may be that of a coat, which the colour below does not weaken.
    private const float LeastAlbedo = 0.1f;

    // Squared differences of albedos below it, which have nothing to explain.
    private const float SmallestSpread = 1e-6f;

    /// <summary>Returns a factor for each channel.</summary>
    public static PaddedPlane[] Of(HalfPlanes[] halves)
    {
        PaddedPlane[][] albedos = [.. halves.Select(h => h.Albedo.Select(a => a.With((x, y) => Known(a, h.Normal, x, y))).ToArray())];
        PaddedPlane[] means = Means(albedos[0], albedos[1]);
        PaddedPlane[] around = [.. means.Select(m => m.Blurred(Radius))];
        PaddedPlane share = Followed(halves, albedos, means, around);
        return [.. means.Select((mean, i) => mean.With((x, y) =>
        {
            FloatW middle = around[i].Load(x, y);
            return FloatW.MultiplyAdd(share.Load(x, y), mean.Load(x, y) - middle, middle);
        }))];
    }

    /// <summary>Means of two planes each.</summary>
    public static PaddedPlane[] Means(PaddedPlane[] a, PaddedPlane[] b) =>
        [.. a.Select((p, i) => p.With((x, y) => 0.5f * (p.Load(x, y) + b[i].Load(x, y))))];

    // Where rays of a pixel miss all surfaces, the mean of their normals is shorter, and what they see counts as white.
    private static FloatW Known(PaddedPlane albedo, PaddedPlane[] normal, int x, int y)
    {
        FloatW squares = 0f;
        foreach (PaddedPlane plane in normal)
        {
            FloatW value = plane.Load(x, y);
            squares = FloatW.MultiplyAdd(value, value, squares);
        }

        FloatW known = albedo.Load(x, y) + 1f - FloatW.Min(1f, FloatW.Sqrt(squares));
        return FloatW.Max(known, LeastAlbedo);
    }

    // The slope of a line through the colours over the albedos of the surroundings, both relative to their means: 1 where the light is even
    // and the surfaces are matt. Each half's colours meet the other one's albedos, so that noise that they have in common has no share.
    private static PaddedPlane Followed(HalfPlanes[] halves, PaddedPlane[][] albedos, PaddedPlane[] means, PaddedPlane[] around)
    {
        PaddedPlane[] colors = [.. Means(halves[0].Color, halves[1].Color).Select(c => c.Blurred(Radius))];
        PaddedPlane[] together = [.. means.Select((m, i) => m.With((x, y) =>
        {
            (FloatW color, FloatW albedo) = (colors[i].Load(x, y), around[i].Load(x, y));
            FloatW Product(int half) => (halves[half].Color[i].Load(x, y) - color) * (albedos[1 - half][i].Load(x, y) - albedo);
            return 0.5f * (Product(0) + Product(1));
        }).Blurred(Radius))];
        PaddedPlane[] spreads = [.. means.Select((m, i) => m.With((x, y) =>
        {
            FloatW d = m.Load(x, y) - around[i].Load(x, y);
            return d * d;
        }).Blurred(Radius))];
        return means[0].With((x, y) =>
        {
            FloatW slope = 0f;
            FloatW spread = SmallestSpread;
            for (int i = 0; i < means.Length; i++)
            {
                FloatW color = colors[i].Load(x, y);
                slope += (color > 0f).Select(together[i].Load(x, y) * around[i].Load(x, y) / color, 0f);
                spread += spreads[i].Load(x, y);
            }

            slope /= spread;
            return FloatW.Max(0f, FloatW.Min(1f, FloatW.Min(slope, 2f - slope)));
        }).Blurred(Radius);
    }
}
