using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

public sealed class ImageFileTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("a.png")]
    [InlineData("a.PFM")]
    [InlineData("a.exr")]
    public void The_format_is_recognized_by_content_when_reading(string name)
    {
        var picture = new Picture(3, 2, [0, 1, 0, 1, 0, 1, 1, 1, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
        ImageFile.Write(_folder[name], picture);
        File.Move(_folder[name], _folder["renamed.txt"]);
        TestPictures.AssertSameBits(picture, ImageFile.Read(_folder["renamed.txt"]));
    }

    [LinuxFact]
    public async Task A_picture_is_read_from_a_pipe_in_one_go()
    {
        var picture = new Picture(2, 1, [0, 1, 0, 1, 0, 1]);
        byte[] file = ImageFile.Encode(".exr", picture, new()
        {
            Metadata = [new("Scene", "s.json")],
            ExrLayers = [new("id.Y", ExrPixelType.Uint, (_, row) => row.Span.Fill(uint.MaxValue))],
        });
        using System.IO.Pipes.AnonymousPipeServerStream pipe = new();

        // An end that nobody has asked for is closed with the other one.
        string path = $"/proc/self/fd/{pipe.GetClientHandleAsString()}";
        Task writing = Task.Run(() =>
        {
            pipe.Write(file);
            pipe.Dispose();
        });
        Assert.False(ImageFile.IsImage(path));
        (Picture read, IReadOnlyList<KeyValuePair<string, string>> texts, IReadOnlyList<ExrLayerChannel> layers) = ImageFile.ReadAll(path);
        await writing;
        TestPictures.AssertSameBits(picture, read);
        Assert.Equal([new("Scene", "s.json")], texts);
        double[] row = new double[2];
        Assert.Single(layers).ReadRow(0, row);
        Assert.Equal(("id.Y", ExrPixelType.Uint, uint.MaxValue), (layers[0].Name, layers[0].Type, row[1]));
    }

    [Theory]
    [InlineData("a.png", 3f)]
    [InlineData("a.pfm", 0.5f)]
    [InlineData("a.exr", 0.5f)]
    public void Exposure_and_tone_map_count_for_PNG_alone(string name, float expected)
    {
        // 0.5 × 2² = 2, which Reinhard's curve takes to 2/3.
        var options = new ImageWriteOptions { BitDepth = 16, Exposure = 2, ToneMap = ToneMap.Reinhard };
        ImageFile.Write(_folder[name], new Picture(1, 1, [0.5f, 0.5f, 0.5f]), options);
        float read = ImageFile.Read(_folder[name]).Pixels[0];
        Assert.Equal(expected == 3 ? 2f / 3 : expected, read, 1e-4f);
    }

    [Fact]
    public void Raw_values_are_not_decoded()
    {
        ImageFile.Write(_folder["a.png"], new Picture(1, 1, [0.5f, 0.5f, 0.5f]));
        Assert.Equal(188 / 255f, ImageFile.Read(_folder["a.png"], raw: true).Pixels[0]);
        Assert.Equal(SrgbCurve.Decode8(188), ImageFile.Read(_folder["a.png"]).Pixels[0]);
    }

    [Theory]
    [InlineData("a.png", "λ")]
    [InlineData("a.exr", "λ")]
    [InlineData("a.jpg", "λ")]
    [InlineData("a.hdr", "λ")]
    [InlineData("a.pfm", null)]
    public void Metadata_is_kept_where_the_format_can(string name, string? expected)
    {
        ImageFile.Write(_folder[name], new Picture(1, 1), new() { Metadata = [new("Key", "λ")] });
        Assert.Equal(expected, ImageFile.ReadText(_folder[name]).SingleOrDefault().Value);
    }

    [Theory]
    [InlineData("a.pgn", "the extension '.pgn' is none of .png, .jpg, .jpeg, .pfm, .exr, .hdr (did you mean '.png'?)")]
    [InlineData("a.ex", "(did you mean '.exr'?)")]
    [InlineData("a.tiff", "the extension '.tiff' is none of .png, .jpg, .jpeg, .pfm, .exr, .hdr.")]
    [InlineData("a", "its name has none of the extensions")]
    [InlineData("missing/a.png", "does not exist")]
    public void A_name_that_cannot_be_written_is_refused_beforehand_and_in_the_end(string name, string message)
    {
        Assert.Contains(message, Assert.Throws<ImageWriteException>(() => ImageFile.Check(_folder[name])).Message);
        Assert.Contains(message, Assert.Throws<ImageWriteException>(() => ImageFile.Write(_folder[name], new Picture(1, 1))).Message);
    }

    [Fact]
    public void Options_that_cannot_be_met_are_refused_and_leave_nothing()
    {
        ImageWriteOptions[] bad = [new() { BitDepth = 12 }, new() { Exposure = float.NaN }, new() { ToneMap = (ToneMap)9 }, new() { Metadata = [new("", "x")] }];
        foreach (ImageWriteOptions options in bad)
        {
            string message = Assert.Throws<ImageWriteException>(() => ImageFile.Write(_folder["a.png"], new Picture(1, 1), options)).Message;
            Assert.DoesNotContain("Parameter", message);
        }

        Assert.Empty(Directory.GetFileSystemEntries(_folder.Path));
    }

    [Fact]
    public void A_file_that_cannot_be_read_is_named_with_the_reason()
    {
        File.WriteAllText(_folder["a.png"], "GIF89a");
        string unknown = Assert.Throws<PictureException>(() => ImageFile.Read(_folder["a.png"])).Message;
        Assert.Equal($"Cannot read the picture '{_folder["a.png"]}': its first bytes are not those of a supported picture format (PNG, JPEG, PFM, OpenEXR and Radiance HDR).", unknown);
        Assert.Contains("no such file", Assert.Throws<PictureException>(() => ImageFile.Read(_folder["b.png"])).Message);
        Assert.Contains("folder", Assert.Throws<PictureException>(() => ImageFile.Read(_folder.Path)).Message);
        Assert.Throws<PictureException>(() => ImageFile.Read(""));
        Assert.Throws<PictureException>(() => ImageFile.ReadText(_folder["a.png"]));
    }
}
