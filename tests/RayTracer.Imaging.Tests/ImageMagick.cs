using System.Buffers.Binary;
using System.Text;

namespace RayTracer.Imaging.Tests;

/// <summary>ImageMagick, an independent reader and writer of PNG, PFM and OpenEXR, in a build that computes with floats.</summary>
internal static class ImageMagick
{
    private static readonly string? s_program = Array.Find(["magick", "convert-im6.q16hdri", "convert"], ComputesWithFloats);

    /// <summary>Skips the test where there is no such program.</summary>
    public static void SkipUnlessThere() => Skip.If(s_program is null, "ImageMagick, computing with floats (HDRI), is not installed");

    /// <summary>Runs the program: inputs, options, output.</summary>
    public static void Convert(params string[] arguments)
    {
        (int exitCode, string output) = ProgramFactAttribute.Run(s_program!, arguments);
        Assert.True(exitCode == 0, output);
    }

    /// <summary>Reads a binary PPM file of 16 bits a channel.</summary>
    public static (int Width, int Height, int[] Samples) ReadPpm(string path)
    {
        byte[] file = File.ReadAllBytes(path);
        string[] header = Encoding.Latin1.GetString(file, 0, Math.Min(40, file.Length)).Split((char[])[' ', '\n'], 5);
        Assert.Equal(("P6", "65535"), (header[0], header[3]));
        int start = header.Take(4).Sum(word => word.Length + 1);
        int[] samples = [.. Enumerable.Range(0, (file.Length - start) / 2).Select(i => (int)BinaryPrimitives.ReadUInt16BigEndian(file.AsSpan(start + (2 * i))))];
        return (int.Parse(header[1]), int.Parse(header[2]), samples);
    }

    private static bool ComputesWithFloats(string program)
    {
        try
        {
            string version = ProgramFactAttribute.Run(program, "-version").Output;
            return version.Contains("ImageMagick", StringComparison.Ordinal) && version.Contains("HDRI", StringComparison.Ordinal);
        }
        catch (System.ComponentModel.Win32Exception)
        {
            return false;
        }
    }
}
