using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Tests.Sampling;

public class HashTests
{
    private static readonly uint s_seed = (uint)TestSettings.Seed * 7919u;

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(uint.MaxValue)]
    public void Pixel_keys_of_one_seed_are_all_different(uint seed)
    {
        const int pixels = 1 << 21;
        Assert.Equal(pixels, Keys(seed, pixels).Count);
    }

    [Fact]
    public void Different_seeds_share_no_more_keys_than_chance_would_have_it()
    {
        // A key of one picture is among a million of another picture's with probability 2²⁰/2³². Keys that mix seed and pixel too
        // little would be the same ones in another order.
        const int pixels = 1 << 20;
        HashSet<uint> keys = Keys(s_seed, pixels);
        foreach (uint other in new[] { s_seed + 1, s_seed + 2, s_seed + 1024, s_seed + 65536, ~s_seed })
        {
            int common = Keys(other, pixels).Count(keys.Contains);
            ErrorBudget.Samplers.Check(PValues.Binomial(common, pixels, pixels / 4294967296.0), $"keys that seeds {s_seed} and {other} have in common");
        }
    }

    [Fact]
    public void Every_bit_of_seed_and_pixel_changes_half_of_the_bits_of_the_key()
    {
        for (int bit = 0; bit < 64; bit++)
        {
            int changed = 0;
            const int trials = 2000;
            for (uint i = 0; i < trials; i++)
            {
                (uint seed, uint pixel) = (s_seed + i, (i * 977) + 13);
                uint other = bit < 32 ? Hash.PixelKey(seed ^ (1u << bit), pixel) : Hash.PixelKey(seed, pixel ^ (1u << (bit - 32)));
                changed += System.Numerics.BitOperations.PopCount(other ^ Hash.PixelKey(seed, pixel));
            }

            ErrorBudget.Samplers.Check(PValues.Binomial(changed, 32 * trials, 0.5), bit < 32 ? $"key bits that seed bit {bit} changes" : $"key bits that pixel bit {bit - 32} changes");
        }
    }

    [Fact]
    public void Mixing_lanes_is_mixing_numbers()
    {
        UIntW mixed = Hash.Mix(UIntW.Iota * 0x01234567u);
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            Assert.Equal(Hash.Mix((uint)lane * 0x01234567u), mixed[lane]);
        }
    }

    private static HashSet<uint> Keys(uint seed, int pixels) => [.. Enumerable.Range(0, pixels).Select(p => Hash.PixelKey(seed, (uint)p))];
}
