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
        if (sampler.Type is "multijitter" or "orthogonal" or "ldsampler")
        {
            sampler.Log.Warn(sampler.TypePlace, $"the sampler \"sobol\" replaces {Quotation.Of(sampler.Type)}: the noise of the picture differs");
        }
        else if (sampler.Type is not ("independent" or "stratified"))
        {
            sampler.UnknownType("samplers", "independent", "stratified", "multijitter", "orthogonal", "ldsampler");
        }

        count = sampler.Type == "stratified" ? Square(sampler, count) : count;
        sampler.Finish();
        SamplerKind kind = sampler.Type switch { "independent" => SamplerKind.Independent, "stratified" => SamplerKind.Jittered, _ => SamplerKind.Sobol };
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
