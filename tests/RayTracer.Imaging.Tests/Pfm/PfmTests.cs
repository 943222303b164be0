using System.Text;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

public class PfmTests
{
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Colour_survives_bit_for_bit(bool bigEndian)
    {
        Picture picture = TestPictures.Noise(7, 5);
        picture.Pixels[0] = float.NaN;
        picture.Pixels[1] = float.NegativeInfinity;
        picture.Pixels[2] = float.NegativeZero;
        byte[] file = TestPictures.Bytes(stream => PfmWriter.Write(stream, picture, bigEndian: bigEndian));
        TestPictures.AssertSameBits(picture, PfmReader.Read(file));
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Grey_is_luminance_in_three_channels(bool bigEndian)
    {
        Picture picture = TestPictures.Noise(3, 2);
        Picture grey = PfmReader.Read(TestPictures.Bytes(stream => PfmWriter.Write(stream, picture, grey: true, bigEndian)));
        for (int i = 0; i < picture.Pixels.Length; i += 3)
        {
            float luminance = new Rgb(picture.Pixels[i], picture.Pixels[i + 1], picture.Pixels[i + 2]).Luminance;
            Assert.Equal([luminance, luminance, luminance], grey.Pixels[i..(i + 3)]);
        }
    }

    [Fact]
    public void Rows_stand_from_bottom_to_top()
    {
        byte[] file = [.. "Pf 1 2 -1 "u8, .. BitConverter.GetBytes(5f), .. BitConverter.GetBytes(7f)];
        Assert.Equal([7, 7, 7, 5, 5, 5], PfmReader.Read(file).Pixels);
    }

    [Theory]
    [InlineData("PF\n4 4\n-1.0\nabc", "cut off")]
    [InlineData("PF\n100000 100000\n-1.0\n", "at most")]
    [InlineData("PF\n0 4\n-1.0\n", "at least 1")]
    [InlineData("PF\n4\n", "height '' is not a whole number")]
    [InlineData("PF\nfour 4\n-1.0\n", "width 'four'")]
    [InlineData("PF\n4 4\n0\n", "scale '0'")]
    [InlineData("PF\n4 4\nnan\n", "scale 'nan'")]
    [InlineData("PF\n4 4", "scale ''")]
    public void Bad_files_are_refused(string file, string message) =>
        Assert.Contains(message, TestPictures.Refusal(Encoding.ASCII.GetBytes(file)));

    [Fact]
    public void Damage_gives_nothing_but_a_PictureException() =>
        TestPictures.Fuzz(TestPictures.Bytes(stream => PfmWriter.Write(stream, TestPictures.Noise(9, 6))), file => PfmReader.Read(file));
}
