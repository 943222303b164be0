using System.Globalization;
using System.Text.Json;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

/// <summary>Reads Cryptomattes as a compositing program does: from the texts and layers of a file alone. Covers `CryptomatteLayers`.</summary>
public class CryptomatteLayersTests
{
    // A ball before a board, both out of focus, so that many pixels show both; ten more things behind a corner.
    private static readonly Lazy<(AovFilm Film, byte[] File)> s_made = new(() =>
    {
        string crowd = string.Join(", ", Enumerable.Range(0, 10).Select(i => FormattableString.Invariant($$"""{ "type": "sphere", "name": "dot {{i}}", "center": [{{-1.3 + (0.05 * i)}}, 1.4, 1], "radius": 0.06 }""")));
        Scene scene = TestScenes.Build($$"""
            { "render": { "width": 16, "height": 16, "samplesPerPixel": 64 },
              "camera": { "position": [0, 0, 6], "lookAt": [0, 0, 0], "fieldOfView": 38, "lens": { "apertureRadius": 0.2, "focusDistance": 3 } },
              "materials": { "gold": { "type": "roughConductor", "metal": "gold" } },
              "shapes": [ { "type": "sphere", "name": "the \"ball\"", "center": [0, 0, 0], "radius": 0.7, "material": "gold" },
                { "type": "rectangle", "name": "bøard", "corner": [-3, -3, -1], "edgeU": [6, 0, 0], "edgeV": [0, 4, 0] }, {{crowd}} ] }
            """);
        AovFilm film = new(new(16, 16), [new CryptomatteImage(CryptomatteKind.Object), new CryptomatteImage(CryptomatteKind.Material), new DepthImage()]);
        new FirstHitPass(scene).Render(film);
        byte[] file = TestPictures.Bytes(s => ExrWriter.Write(s, TestPictures.Noise(16, 16), metadata: CryptomatteLayers.Texts(film), layers: AovFiles.Layers(film)));
        return (film, file);
    });

    [Theory]
    [InlineData("CryptoObject", "3ae39a5", "the \"ball\"")]
    [InlineData("CryptoObject", "3ae39a5", "bøard")]
    [InlineData("CryptoMaterial", "be359d6", "gold")]
    public void A_mask_by_a_name_is_the_coverage_of_that_thing(string layer, string key, string name)
    {
        Dictionary<string, string> texts = s_made.Value.File is var file ? new(ExrReader.ReadText(file)) : [];
        Assert.Equal((layer, "MurmurHash3_32", "uint32_to_float32"), (texts[$"cryptomatte/{key}/name"], texts[$"cryptomatte/{key}/hash"], texts[$"cryptomatte/{key}/conversion"]));
        using JsonDocument manifest = JsonDocument.Parse(texts[$"cryptomatte/{key}/manifest"]);
        uint id = uint.Parse(manifest.RootElement.GetProperty(name).GetString()!, NumberStyles.HexNumber, CultureInfo.InvariantCulture);
        AovFilm film = s_made.Value.Film;
        CryptomatteImage image = film.Images.OfType<CryptomatteImage>().Single(i => i.Layer == layer);
        float[] mask = Mask(file, layer, id);
        int soft = 0;
        for (int i = 0; i < mask.Length; i++)
        {
            double covered = film.Covering(image, i % 16, i / 16).FirstOrDefault(c => c.Id == id).Part;
            Assert.Equal((float)covered, mask[i]);
            soft += mask[i] is > 0 and < 1 ? 1 : 0;
        }

        Assert.True(soft > 10);
    }

    [Fact]
    public void Ranks_fall_and_parts_come_to_no_more_than_1()
    {
        byte[] file = s_made.Value.File;
        float[][] parts = [.. Enumerable.Range(0, 6).Select(rank => Channel(file, $"CryptoObject{rank / 2:00}.{"GA"[rank % 2]}"))];
        float[][] ids = [.. Enumerable.Range(0, 6).Select(rank => Channel(file, $"CryptoObject{rank / 2:00}.{"RB"[rank % 2]}"))];
        for (int i = 0; i < 256; i++)
        {
            Assert.True(parts.Sum(p => p[i]) <= 1);
            for (int rank = 0; rank < 6; rank++)
            {
                Assert.True(rank == 0 || parts[rank][i] <= parts[rank - 1][i]);
                Assert.Equal(parts[rank][i] > 0, ids[rank][i] != 0);
            }
        }

        Assert.Contains(parts[5], p => p > 0);
    }

    [Fact]
    public void Only_what_is_seen_is_in_the_manifest_and_other_layers_stay()
    {
        Dictionary<string, string> texts = new(ExrReader.ReadText(s_made.Value.File));
        using JsonDocument manifest = JsonDocument.Parse(texts["cryptomatte/be359d6/manifest"]);
        Assert.Equal(["diffuse 1", "gold"], manifest.RootElement.EnumerateObject().Select(p => p.Name));
        Assert.Equal(256, ExrReader.ReadChannel(s_made.Value.File, "depth.Z").Length);
    }

    private static float[] Mask(byte[] file, string layer, uint id)
    {
        float[] mask = new float[256];
        for (int rank = 0; rank < 6; rank++)
        {
            float[] ids = Channel(file, $"{layer}{rank / 2:00}.{"RB"[rank % 2]}");
            float[] parts = Channel(file, $"{layer}{rank / 2:00}.{"GA"[rank % 2]}");
            for (int i = 0; i < mask.Length; i++)
            {
                mask[i] += BitConverter.SingleToUInt32Bits(ids[i]) == id ? parts[i] : 0;
            }
        }

        return mask;
    }

    private static float[] Channel(byte[] file, string name) => [.. ExrReader.ReadChannel(file, name).Select(v => (float)v)];
}
