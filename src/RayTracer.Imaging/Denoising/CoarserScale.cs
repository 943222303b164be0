using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// Takes the low frequencies of a denoised picture from the same picture that was denoised at half the size, where noise is weaker and
/// windows reach twice as far (Delbracio et al. 2014, multi-scale).
/// </summary>
internal static class CoarserScale
{
    // A full correction would take over the coarse picture's noise too.
    private const float Strength = 0.8f;

    // A bright spot that only one of the scales keeps must not leave black beside it: of what is darker at both scales, so much stays at least.
    private const float LeastShare = 0.5f;

    /// <summary>Corrects a picture.</summary>
    /// <param name="fine">The picture.</param>
    /// <param name="input">The planes that it was made of.</param>
    /// <param name="coarse">The picture of half the size.</param>
    /// <param name="coarseInput">The planes that this was made of.</param>
    public static void Correct(Picture fine, DenoiserInput input, Picture coarse, DenoiserInput coarseInput) => Parallel.For(0, 3, channel =>
    {
        PaddedPlane plane = new(fine.Width, fine.Height);
        for (int i = channel; i < fine.Pixels.Length; i += 3)
        {
            plane[i / 3 % fine.Width, i / 3 / fine.Width] = fine.Pixels[i];
        }

        // Beyond an odd edge, pixels repeat, as they do in the halves.
        plane.Extend();
        PaddedPlane change = plane.Halved(input.Sampled, 1);
        PaddedPlane coarseLight = new(coarse.Width, coarse.Height);
        for (int y = 0; y < coarse.Height; y++)
        {
            for (int x = 0; x < coarse.Width; x++)
            {
                float surface = coarseInput.Surfaces[channel][x, y];
                float light = coarse.Pixels[(3 * ((y * coarse.Width) + x)) + channel];
                coarseLight[x, y] = light / surface;
                change[x, y] = Strength * coarseInput.Sampled[x, y] * ((light - change[x, y]) / surface);
            }
        }

        change.Extend();
        coarseLight.Extend();
        for (int y = 0; y < fine.Height; y++)
        {
            for (int x = 0; x < fine.Width; x++)
            {
                if (input.Variances[0][x, y] + input.Variances[1][x, y] > 0 && input.Sampled[x, y] > 0)
                {
                    ref float value = ref fine.Pixels[(3 * ((y * fine.Width) + x)) + channel];
                    float surface = input.Surfaces[channel][x, y];
                    float least = LeastShare * float.Max(0, float.Min(value, surface * Between(coarseLight, x, y)));
                    value = float.Max(float.Min(value, least), float.FusedMultiplyAdd(surface, Between(change, x, y), value));
                }
            }
        }
    });

    // Between the four pixels of half the size that are nearest: the middles of theirs and of ours lie a quarter of the distance apart.
    private static float Between(PaddedPlane plane, int x, int y)
    {
        (int left, int top) = (x >> 1, y >> 1);
        (int beside, int above) = (left + ((x & 1) * 2) - 1, top + ((y & 1) * 2) - 1);
        return (9f / 16 * plane[left, top]) + (3f / 16 * (plane[beside, top] + plane[left, above])) + (1f / 16 * plane[beside, above]);
    }
}
