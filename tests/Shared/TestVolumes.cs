using System.Buffers.Binary;
using System.Runtime.InteropServices;

namespace RayTracer.Testing;

/// <summary>Files of grids.</summary>
public static class TestVolumes
{
    /// <summary>The bytes of one of Mitsuba's .vol files.</summary>
    /// <param name="x">Points along x.</param>
    /// <param name="y">Points along y.</param>
    /// <param name="z">Points along z.</param>
    /// <param name="value">The values of the channels at a point.</param>
    public static byte[] Vol(int x, int y, int z, Func<int, int, int, float[]> value)
    {
        float[] values = [.. Enumerable.Range(0, x * y * z).SelectMany(i => value(i % x, i / x % y, i / (x * y)))];
        byte[] bytes = new byte[48 + (4 * values.Length)];
        "VOL"u8.CopyTo(bytes);
        bytes[3] = 3;
        int[] header = [1, x, y, z, values.Length / (x * y * z)];
        for (int i = 0; i < header.Length; i++)
        {
            BinaryPrimitives.WriteInt32LittleEndian(bytes.AsSpan(4 + (4 * i)), header[i]);
        }

        float[] box = [0, 0, 0, 1, 1, 1];
        MemoryMarshal.AsBytes(box.AsSpan()).CopyTo(bytes.AsSpan(24));
        MemoryMarshal.AsBytes(values.AsSpan()).CopyTo(bytes.AsSpan(48));
        return bytes;
    }

    /// <summary>The value of an entry of such a file, by its path, for a scene's text.</summary>
    public static string Write(string path, byte[] bytes)
    {
        File.WriteAllBytes(path, bytes);
        return path.Replace('\\', '/');
    }
}
