using System.Text.Json;
using System.Text.Json.Nodes;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>The header of a film file, which describes its film.</summary>
public sealed record FilmHeader
{
    private const string SettingsKey = "settings";
    private const string ToneKey = "tone";
    private const string WordsKey = "overrides";

    /// <summary>Width in pixels.</summary>
    public required int Width { get; init; }

    /// <summary>Height in pixels.</summary>
    public required int Height { get; init; }

    /// <summary>SHA-256, in hexadecimal digits, of all that decides what a sample comes to: films of one scene have the same.</summary>
    public required string Content { get; init; }

    /// <summary>The samples of each pixel that it holds: ranges in their order, which do not touch.</summary>
    public required IReadOnlyList<SampleRange> Samples { get; init; }

    /// <summary>The samples of each pixel that it is meant to come to hold.</summary>
    public required SampleRange Wanted { get; init; }

    /// <summary>The number of samples that a pixel of the whole picture has.</summary>
    public required int Total { get; init; }

    /// <summary>The part of the picture that was rendered; null for all of it.</summary>
    public Tile? Crop { get; init; }

    /// <summary>The scene's file.</summary>
    public string Scene { get; init; } = "";

    /// <summary>The values that replace what the scene's file says, each written <c>path=value</c>.</summary>
    public IReadOnlyList<string> Settings { get; init; } = [];

    /// <summary>The words of a command line that a file of the first format holds in place of settings; null in any other.</summary>
    public IReadOnlyList<string>? Words { get; init; }

    /// <summary>A text on how a display shows its picture; null for light as it is.</summary>
    public string? Tone { get; init; }

    /// <summary>The program that wrote it.</summary>
    public string Software { get; init; } = "";

    /// <summary>Its planes beside the picture, in the file's order; also what this version of the program does not know.</summary>
    public IReadOnlyList<FilmPlane> Planes { get; init; } = [];

    /// <summary>True where it holds all the samples that it is meant to.</summary>
    public bool IsComplete => Samples is [var only] && only == Wanted;

    /// <summary>The samples as people write them, the last one included: 0..63.</summary>
    public string SamplesText => Samples.Count == 0 ? "none" : string.Join(", ", Samples.Select(Text));

    /// <summary>A range as people write it, the last one included.</summary>
    public static string Text(SampleRange range) => $"{range.First}..{range.End - 1}";

    /// <summary>Writes it as JSON.</summary>
    internal byte[] ToBytes()
    {
        JsonObject json = new()
        {
            ["width"] = Width,
            ["height"] = Height,
            ["content"] = Content,
            ["samples"] = List(Samples.SelectMany(r => new[] { r.First, r.End })),
            ["wanted"] = List([Wanted.First, Wanted.End]),
            ["total"] = Total,
        };
        if (Crop is { } crop)
        {
            json["crop"] = List([crop.X, crop.Y, crop.Width, crop.Height]);
        }

        json["scene"] = Scene;
        json[Words is null ? SettingsKey : WordsKey] = List(Words ?? Settings);
        if (Tone is not null)
        {
            json[ToneKey] = Tone;
        }

        json["software"] = Software;
        if (Planes.Count > 0)
        {
            json["planes"] = new JsonArray([.. Planes.Select(p => new JsonObject { ["name"] = p.Name, ["sums"] = List(p.Sums) })]);
        }

        return JsonSerializer.SerializeToUtf8Bytes(json);
    }

    /// <summary>Reads it.</summary>
    /// <exception cref="PictureException">It is damaged.</exception>
    internal static FilmHeader Of(byte[] bytes)
    {
        try
        {
            using JsonDocument document = JsonDocument.Parse(bytes);
            JsonElement json = document.RootElement;
            int[] crop = json.TryGetProperty("crop", out JsonElement part) ? Numbers(part) : [];
            int[] samples = Numbers(json.GetProperty("samples"));
            int[] wanted = Numbers(json.GetProperty("wanted"));
            FilmHeader header = new()
            {
                Width = json.GetProperty("width").GetInt32(),
                Height = json.GetProperty("height").GetInt32(),
                Content = Text(json.GetProperty("content")),
                Samples = [.. samples.Chunk(2).Select(r => new SampleRange(r[0], r[1]))],
                Wanted = new(wanted[0], wanted[1]),
                Total = json.GetProperty("total").GetInt32(),
                Crop = crop.Length == 4 ? new(crop[0], crop[1], crop[2], crop[3]) : null,
                Scene = Text(json.GetProperty("scene")),
                Settings = json.TryGetProperty(SettingsKey, out JsonElement settings) ? [.. settings.EnumerateArray().Select(Text)] : [],
                Words = json.TryGetProperty(SettingsKey, out _) ? null : [.. json.GetProperty(WordsKey).EnumerateArray().Select(Text)],
                Tone = json.TryGetProperty(ToneKey, out JsonElement tone) ? Text(tone) : null,
                Software = Text(json.GetProperty("software")),
                Planes = json.TryGetProperty("planes", out JsonElement planes) ? [.. planes.EnumerateArray().Select(Plane)] : [],
            };
            return header.IsSound ? header : throw new PictureException("its header makes no sense");
        }
        catch (Exception e) when (e is JsonException or KeyNotFoundException or InvalidOperationException or FormatException or IndexOutOfRangeException)
        {
            throw new PictureException($"its header is damaged ({e.Message.ReplaceLineEndings(" ").TrimEnd('.')})", e);
        }
    }

    private bool IsSound => Width > 0 && Height > 0 && Samples.All(r => r.First >= 0 && r.End > r.First) && Wanted.First >= 0 && Wanted.End > Wanted.First
        && Samples.Zip(Samples.Skip(1)).All(p => p.First.End < p.Second.First)
        && Planes.All(p => p.Sums.Count > 0) && Planes.DistinctBy(p => p.Name).Count() == Planes.Count
        && Total > 0 && (Crop is not { } c || (c is { X: >= 0, Y: >= 0, Width: > 0, Height: > 0 } && c.X <= Width - c.Width && c.Y <= Height - c.Height));

    /// <summary>Makes sure that all planes are known: of others it is not known what samples add to them.</summary>
    /// <exception cref="PictureException">One is not.</exception>
    internal FilmHeader WithKnownPlanes() => Planes.FirstOrDefault(p => !p.IsKnown) is { } unknown
        ? throw new PictureException($"it holds the plane '{unknown}' ({string.Join(", ", unknown.Sums)}), which this version of the program "
            + $"does not know: use the one that wrote it, {Software}")
        : this;

    private static FilmPlane Plane(JsonElement json) =>
        FilmPlane.Of(Text(json.GetProperty("name")), [.. json.GetProperty("sums").EnumerateArray().Select(Text)]);

    private static string Text(JsonElement word) => word.GetString() ?? throw new FormatException("a text is missing");

    private static int[] Numbers(JsonElement list) => [.. list.EnumerateArray().Select(n => n.GetInt32())];

    private static JsonArray List<T>(IEnumerable<T> values) => new([.. values.Select(v => (JsonNode?)JsonValue.Create(v))]);
}
