using System.Diagnostics;
using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Testing;

/// <summary>Pictures and damage for the codec tests.</summary>
internal static class TestPictures
{
    /// <summary>Noise from a little below 0 to a little above 1, with smooth parts.</summary>
    public static Picture Noise(int width, int height, int seed = 1)
    {
        var random = new Random(seed);
        var picture = new Picture(width, height);
        for (int i = 0; i < picture.Pixels.Length; i++)
        {
            picture.Pixels[i] = i % 7 < 3 ? 0.25f : (random.NextSingle() * 1.2f) - 0.1f;
        }

        return picture;
    }

    public static byte[] Bytes(Action<Stream> write)
    {
        using var stream = new MemoryStream();
        write(stream);
        return stream.ToArray();
    }

    public static void AssertSameBits(Picture expected, Picture actual)
    {
        Assert.Equal((expected.Width, expected.Height), (actual.Width, actual.Height));
        Assert.Equal(expected.Pixels.Select(BitConverter.SingleToInt32Bits), actual.Pixels.Select(BitConverter.SingleToInt32Bits));
    }

    /// <summary>Reads damaged variants of a file: nothing but a <see cref="PictureException"/> may escape, and memory and time stay bounded.</summary>
    /// <param name="file">A valid file.</param>
    /// <param name="read">The reader.</param>
    /// <param name="mend">Makes a damaged file pass shallow checks (such as checksums), so that the damage reaches deeper.</param>
    /// <param name="rounds">How many variants.</param>
    public static void Fuzz(byte[] file, Action<byte[]> read, Action<byte[]>? mend = null, int rounds = 1500)
    {
        const long Budget = 64 << 20;
        var random = new Random(42 + TestSettings.Seed);
        int refused = 0;
        for (int round = 0; round < rounds; round++)
        {
            byte[] damaged = file[..(round % 5 == 0 ? random.Next(file.Length) : file.Length)];
            for (int flip = random.Next(3); flip >= 0 && damaged.Length > 0; flip--)
            {
                int at = random.Next(2) == 0 ? random.Next(damaged.Length) : random.Next(Math.Min(400, damaged.Length));
                damaged[at] = random.Next(3) == 0 ? (byte)random.Next(256) : (byte)(damaged[at] ^ (1 << random.Next(8)));
            }

            mend?.Invoke(damaged);
            long start = Stopwatch.GetTimestamp();
            long before = GC.GetAllocatedBytesForCurrentThread();
            try
            {
                ImageFile.Describe(damaged);
            }
            catch (PictureException e)
            {
                Assert.DoesNotContain('\n', e.Message);
            }

            try
            {
                read(damaged);
            }
            catch (PictureException e)
            {
                refused++;
                Assert.DoesNotContain('\n', e.Message);
            }

            // No measure of speed: a file of this size that keeps a reader busy for so long would keep it busy for ever.
            Assert.InRange(Stopwatch.GetElapsedTime(start).TotalSeconds, 0, 10);
            Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, Budget);
        }

        Assert.InRange(refused, rounds / 15, rounds);
    }

    /// <summary>Reads a file and returns the message of the refusal.</summary>
    public static string Refusal(byte[] file) => Assert.Throws<PictureException>(() => ImageFile.Decode(file)).Message;
}
