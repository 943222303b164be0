using RayTracer.Description;

namespace RayTracer.Import;

/// <summary>Chooses the sampler that is nearest to theirs.</summary>
internal static class MitsubaSamplers
{
    /// <summary>Samples a pixel where nothing is said.</summary>
    public const int StandardCount = 4;

    /// <summary>The render settings for a sampler.</summary>
    public static RenderDescription Read(MitsubaObject sampler, RenderDescription render)
    {
        sampler.Ignore("jitter");
        int count = sampler.Integer("sample_count", StandardCount, 1);
        int seed = sampler.Integer("seed", 0, 0);
        SamplerKind kind = SamplerKind.Sobol;
        switch (sampler.Type)
        {
            case "independent":
                kind = SamplerKind.Independent;
                break;
            case "stratified":
                kind = SamplerKind.Jittered;
                count = Square(sampler, count);
                break;
            case "multijitter" or "orthogonal" or "ldsampler":
                sampler.Log.Warn(sampler.TypePlace, $"the sampler \"sobol\" replaces {Quotation.Of(sampler.Type)}: the noise of the picture differs");
                break;
            default:
                sampler.Log.Unknown(sampler.TypePlace, $"samplers of type {Quotation.Of(sampler.Type)} are not supported", sampler.Type, ["independent", "stratified", "multijitter", "orthogonal", "ldsampler"]);
                break;
        }

        sampler.Finish();
        return render with { SamplesPerPixel = count, Sampler = kind, Seed = seed };
    }

    private static int Square(MitsubaObject sampler, int count)
    {
        int side = (int)double.Ceiling(double.Sqrt(count));
        if (side * side != count)
        {
            sampler.Log.Warn(sampler.PlaceOf("sample_count"), $"a stratified sampler needs a square number of samples: {side * side} replace {count}");
        }

        return side * side;
    }
}
