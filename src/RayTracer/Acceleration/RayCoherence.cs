using System.Numerics;

namespace RayTracer.Acceleration;

/// <summary>Tells rays that belong together as they come, as a camera's do, from those that must be sorted first.</summary>
internal static unsafe class RayCoherence
{
    private const int Samples = 16;

    /// <summary>Returns whether in most blocks all rays point into one octant, by a sample of the blocks.</summary>
    public static bool IsHigh(in RayStream rays)
    {
        int blocks = rays.Count / RayBlock.Size;
        int samples = Math.Min(Samples, blocks);
        int coherent = 0;
        for (int sample = 0; sample < samples; sample++)
        {
            int first = (int)((long)blocks * sample / samples) * RayBlock.Size;
            coherent += SameSigns(rays.DirectionX + first) && SameSigns(rays.DirectionY + first) && SameSigns(rays.DirectionZ + first) ? 1 : 0;
        }

        return 2 * coherent >= samples;
    }

    private static bool SameSigns(float* numbers)
    {
        int negative = 0;
        for (int i = 0; i < RayBlock.Size; i++)
        {
            negative += numbers[i] < 0f ? 1 : 0;
        }

        return negative is 0 or RayBlock.Size;
    }
}
