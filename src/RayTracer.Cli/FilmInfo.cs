using System.Text.Json;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary>What <c>info</c> tells about a film.</summary>
internal static class FilmInfo
{
    /// <summary>Tells it.</summary>
    /// <param name="path">The film.</param>
    /// <param name="withHash">Whether all of it is read, for its hash; this finds damages, too.</param>
    /// <param name="json">As one JSON object.</param>
    /// <param name="streams">Where to write.</param>
    public static void Show(string path, bool withHash, bool json, Streams streams)
    {
        (FilmHeader header, string? hash) = Read(path, withHash);
        long bytes = new FileInfo(path).Length;
        if (json)
        {
            JsonText.Write(streams, writer =>
            {
                writer.WriteString("kind", "film");
                writer.WriteNumber("width", header.Width);
                writer.WriteNumber("height", header.Height);
                writer.WriteNumber("fileBytes", bytes);
                WriteJson(writer, header, hash);
            });
        }
        else
        {
            streams.Output.WriteLine(path);
            streams.Output.WriteLine($"film       {header.Width}×{header.Height} pixels, {FilmMemory.Text(bytes)}");
            Write(header, hash, streams.Output);
        }
    }

    /// <summary>What a film file, or an image that carries its film, says of the film, and the film's hash where that is wanted.</summary>
    public static (FilmHeader Header, string? Hash) Read(string path, bool withHash)
    {
        (FilmHeader header, Film? film) = withHash ? CarriedFilm.Read(path) : (CarriedFilm.ReadHeader(path), null);
        return (header, film?.ComputeHash());
    }

    private static int Held(FilmHeader header) => header.Samples.Sum(r => r.Count);

    /// <summary>Tells all but the size for people.</summary>
    public static void Write(FilmHeader header, string? hash, TextWriter output)
    {
        output.WriteLine($"samples    {header.SamplesText}: {Held(header)} of {header.Wanted.Count} wanted ({FilmHeader.Text(header.Wanted)}), {(header.IsComplete ? "complete" : "not complete")}");
        output.WriteLine($"total      {header.Total} samples a pixel of the whole picture");
        if (header.Crop is { } crop)
        {
            output.WriteLine($"crop       {crop.X},{crop.Y},{crop.Width},{crop.Height}");
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

    /// <summary>Tells all but the size for programs, as members of an object.</summary>
    public static void WriteJson(Utf8JsonWriter json, FilmHeader header, string? hash)
    {
        json.WriteString("samples", header.SamplesText);
        json.WriteNumber("heldSamples", Held(header));
        json.WriteString("wanted", FilmHeader.Text(header.Wanted));
        json.WriteNumber("wantedSamples", header.Wanted.Count);
        json.WriteNumber("totalSamples", header.Total);
        json.WriteBoolean("complete", header.IsComplete);
        if (header.Crop is { } crop)
        {
            json.WriteStartArray("crop");
            foreach (int number in new[] { crop.X, crop.Y, crop.Width, crop.Height })
            {
                json.WriteNumberValue(number);
            }

            json.WriteEndArray();
        }
        else
        {
            json.WriteNull("crop");
        }

        json.WriteString("scene", header.Scene);
        JsonText.Strings(json, "settings", OldFilms.Settings(header));
        json.WriteString("software", header.Software);
        json.WriteString("contentHash", header.Content);
        if (hash is not null)
        {
            json.WriteString("filmHash", hash);
        }
    }
}
