using System.Text.Json.Nodes;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary>The films of <c>info</c>.</summary>
internal static class FilmInfo
{
    /// <summary>Prints what there is to say of a film.</summary>
    /// <param name="path">The film.</param>
    /// <param name="withHash">True if all of it is read, for its hash; this finds damages, too.</param>
    /// <param name="isJson">As one JSON object.</param>
    /// <param name="streams">The streams to write to.</param>
    public static void Show(string path, bool withHash, bool isJson, Streams streams)
    {
        (FilmHeader header, string? hash) = Read(path, withHash);
        long bytes = new FileInfo(path).Length;
        if (isJson)
        {
            JsonObject json = Json(header, hash);
            json.Insert(0, "kind", "film");
            json.Insert(1, "width", header.Width);
            json.Insert(2, "height", header.Height);
            json.Insert(3, "fileBytes", bytes);
            JsonText.Write(streams, json);
        }
        else
        {
            streams.Output.WriteLine(path);
            streams.Output.WriteLine($"film       {header.Width}×{header.Height} pixels, {FilmMemory.Text(bytes)}");
            Write(header, hash, streams.Output);
        }
    }

    /// <summary>
    /// Returns what a film file, or an image that carries its film, says of the film, and the film's hash where that is wanted.
    /// </summary>
    public static (FilmHeader Header, string? Hash) Read(string path, bool withHash)
    {
        (FilmHeader header, Film? film) = withHash ? CarriedFilm.Read(path) : (CarriedFilm.ReadHeader(path), null);
        return (header, film?.ComputeHash());
    }

    private static int Held(FilmHeader header) => header.Samples.Sum(r => r.Count);

    /// <summary>Prints all but the size for people.</summary>
    public static void Write(FilmHeader header, string? hash, TextWriter output)
    {
        output.WriteLine($"samples    {header.SamplesText}: {Held(header)} of {header.Wanted.Count} wanted ({FilmHeader.Text(header.Wanted)}), {(header.IsComplete ? "complete" : "not complete")}");
        output.WriteLine($"total      {header.Total} samples a pixel of the whole picture");
        if (header.Crop is { } crop)
        {
            output.WriteLine($"crop       {crop.X},{crop.Y},{crop.Width},{crop.Height}");
        }

        if (header.Planes.Count > 0)
        {
            output.WriteLine($"planes     {PlainText.Of(string.Join(", ", header.Planes))}");
        }

        output.WriteLine($"scene      {PlainText.Of(header.Scene)}");
        if (OldFilms.Settings(header) is { Count: > 0 } settings)
        {
            output.WriteLine($"settings   {PlainText.Of(string.Join("; ", settings))}");
        }

        output.WriteLine($"software   {PlainText.Of(header.Software)}");
        output.WriteLine($"content    {PlainText.Of(header.Content)}");
        if (hash is not null)
        {
            output.WriteLine($"film hash  {hash}");
        }
    }

    /// <summary>Returns all but the size for programs.</summary>
    public static JsonObject Json(FilmHeader header, string? hash)
    {
        JsonObject json = new()
        {
            ["samples"] = header.SamplesText,
            ["heldSamples"] = Held(header),
            ["wanted"] = FilmHeader.Text(header.Wanted),
            ["wantedSamples"] = header.Wanted.Count,
            ["totalSamples"] = header.Total,
            ["complete"] = header.IsComplete,
            ["crop"] = header.Crop is { } crop ? new JsonArray(crop.X, crop.Y, crop.Width, crop.Height) : null,
            ["planes"] = JsonText.List(header.Planes.Select(p => p.Name)),
            ["scene"] = header.Scene,
            ["settings"] = JsonText.List(OldFilms.Settings(header)),
            ["software"] = header.Software,
            ["contentHash"] = header.Content,
        };
        if (hash is not null)
        {
            json["filmHash"] = hash;
        }

        return json;
    }
}
