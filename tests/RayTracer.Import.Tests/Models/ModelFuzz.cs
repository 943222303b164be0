using RayTracer.Description;

namespace RayTracer.Import.Tests;

/// <summary>Damage for the tests of model readers.</summary>
internal static class ModelFuzz
{
    private const long FreeMemory = 256L << 20;

    /// <summary>
    /// Reads damaged variants of a file: nothing but a <see cref="ModelException"/> of one line may escape, and all memory that is taken
    /// stays below ten times the file and 256 MiB. Some variants must be refused.
    /// </summary>
    public static void Run(byte[] file, Action<byte[]> read, byte[][]? pieces = null)
    {
        int rounds = TestSettings.Scale(200, 5000);
        var random = new Random(2009 + TestSettings.Seed);
        int refused = 0;
        for (int round = 0; round < rounds; round++)
        {
            byte[] damaged = Damage(file, random, pieces);
            long before = GC.GetAllocatedBytesForCurrentThread();
            try
            {
                read(damaged);
            }
            catch (ModelException e)
            {
                refused++;
                Assert.DoesNotContain('\n', e.Message);
                Assert.NotEmpty(e.Message);
            }

            Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, (10 * damaged.Length) + FreeMemory);
        }

        Assert.InRange(refused, rounds / 20, rounds);
    }

    // Cuts, bits, bytes, and pieces put in, taken out or doubled.
    private static byte[] Damage(byte[] file, Random random, byte[][]? pieces)
    {
        List<byte> damaged = [.. file];
        for (int change = random.Next(4); change >= 0 && damaged.Count > 0; change--)
        {
            int at = random.Next(random.Next(3) == 0 ? Math.Min(300, damaged.Count) : damaged.Count);
            switch (random.Next(pieces is null ? 5 : 7))
            {
                case 0 when random.Next(3) == 0:
                    damaged.RemoveRange(at, damaged.Count - at);
                    break;
                case 0 or 1:
                    damaged[at] ^= (byte)(1 << random.Next(8));
                    break;
                case 2:
                    damaged[at] = (byte)random.Next(256);
                    break;
                case 3:
                    damaged.RemoveRange(at, Math.Min(random.Next(20), damaged.Count - at));
                    break;
                case 4:
                    damaged.InsertRange(at, damaged.Slice(at, Math.Min(random.Next(40), damaged.Count - at)));
                    break;
                default:
                    damaged.InsertRange(at, pieces![random.Next(pieces.Length)]);
                    break;
            }
        }

        return [.. damaged];
    }
}
