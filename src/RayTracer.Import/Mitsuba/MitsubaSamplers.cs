using RayTracer.Description;

namespace RayTracer.Import;

/// <summary>Chooses the sampler that is nearest to theirs.</summary>
internal static class MitsubaSamplers
{
    /// <summary>Samples a pixel where nothing is said.</summary>
    public const int StandardCount = 4;

    /// <summary>How a scene is rendered with a sampler.</summary>
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
                sampler.Log.Warn(sampler.TypePlace, $"the sampler \"sobol\" takes the place of {Quotation.Of(sampler.Type)}: the picture has another noise");
                break;
            default:
                sampler.Log.Unknown(sampler.TypePlace, $"samplers of the type {Quotation.Of(sampler.Type)} are not read here", sampler.Type, ["independent", "stratified", "multijitter", "orthogonal", "ldsampler"]);
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
            sampler.Log.Warn(sampler.PlaceOf("sample_count"), $"a stratified sampler takes squares of whole numbers: {side * side} samples take the place of {count}");
        }

        return side * side;
    }
}
