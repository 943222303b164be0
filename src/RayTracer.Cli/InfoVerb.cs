using System.CommandLine;
using System.Text.Json;
using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary><c>raytracer info SCENE</c></summary>
internal static class InfoVerb
{
    public static void Build(Command command, Streams streams)
    {
        Argument<string> scene = new("SCENE") { Description = "The scene file." };
        Option<bool> json = new("--json") { Description = "Prints one JSON object." };
        command.Arguments.Add(scene);
        command.Options.Add(json);
        command.SetAction(result => Show(result.GetValue(scene)!, result.GetValue(json), streams));
    }

    private static int Show(string path, bool json, Streams streams)
    {
        Dictionary<string, long> pictures = [];
        SceneLoadResult result = SceneFile.Load(path, readPicture: (file, raw) =>
        {
            Picture picture = ImageFile.Read(file, raw);
            pictures[file] = sizeof(float) * picture.Pixels.LongLength;
            return picture;
        });
        SceneFile.Show(result, streams);
        if (result.Scene is not { } scene)
        {
            return SceneFile.FailureStatus(path);
        }

        SceneContent content = SceneContent.Of(result.Description!);
        string folder = Path.GetDirectoryName(path) ?? "";
        long textures = content.Images.Sum(i => pictures.GetValueOrDefault(Path.Combine(folder, i.File)));
        if (json)
        {
            WriteJson(scene, content, textures, streams);
        }
        else
        {
            Write(path, scene, content, textures, streams.Output);
        }

        return ExitStatus.Fine;
    }

    private static void Write(string path, Scene scene, SceneContent content, long textures, TextWriter output)
    {
        RenderDescription render = scene.Render;
        output.WriteLine(path);
        output.WriteLine($"shapes     {Counts(content.Shapes)}");
        output.WriteLine($"materials  {Counts(content.Materials)}");
        output.WriteLine($"textures   {Counts(content.Textures)}");
        output.WriteLine($"lights     {scene.Lights.Count}");
        output.WriteLine(FiniteBounds(scene) is { } box ? $"bounds     {Text(box.Minimum)} to {Text(box.Maximum)}" : "bounds     no finite shape");
        output.WriteLine($"picture    {render.Width}×{render.Height} pixels, {render.SamplesPerPixel} samples each ({render.Sampler.ToString().ToLowerInvariant()})");
        output.WriteLine($"memory     film {FilmMemory.Text(FilmBytes(render))}, textures {FilmMemory.Text(textures)}, shapes {FilmMemory.Text(ShapeBytes(scene))}");
    }

    private static string Counts(IReadOnlyDictionary<string, int> counts) => counts.Count == 0 ? "0" :
        $"{counts.Values.Sum()} ({string.Join(", ", counts.Select(c => $"{c.Value} {c.Key}"))})";

    private static string Text(System.Numerics.Vector3 v) => $"({v.X}, {v.Y}, {v.Z})";

    private static long FilmBytes(RenderDescription render) => FilmMemory.Bytes(render.Width, render.Height);

    private static long ShapeBytes(Scene scene)
    {
        long bytes = scene.Primitives.TreeBytes;
        foreach (ShapeBatch batch in scene.Batches)
        {
            bytes += batch.MemoryBytes;
        }

        return bytes;
    }

    private static Bounds? FiniteBounds(Scene scene)
    {
        Bounds box = Bounds.Empty;
        foreach (Shape shape in scene.Shapes)
        {
            box = shape.Bounds.IsFinite ? box.Union(shape.Bounds) : box;
        }

        return box.IsFinite ? box : null;
    }

    private static void WriteJson(Scene scene, SceneContent content, long textures, Streams streams) => JsonText.Write(streams, json =>
    {
        WriteCounts(json, "shapes", content.Shapes);
        WriteCounts(json, "materials", content.Materials);
        WriteCounts(json, "textures", content.Textures);
        json.WriteNumber("lights", scene.Lights.Count);
        Bounds? box = FiniteBounds(scene);
        WriteCorner(json, "boundsMinimum", box?.Minimum);
        WriteCorner(json, "boundsMaximum", box?.Maximum);
        json.WriteNumber("width", scene.Render.Width);
        json.WriteNumber("height", scene.Render.Height);
        json.WriteNumber("samplesPerPixel", scene.Render.SamplesPerPixel);
        json.WriteNumber("filmBytes", FilmBytes(scene.Render));
        json.WriteNumber("textureBytes", textures);
        json.WriteNumber("shapeBytes", ShapeBytes(scene));
    });

    private static void WriteCounts(Utf8JsonWriter json, string key, IReadOnlyDictionary<string, int> counts)
    {
        json.WriteStartObject(key);
        foreach ((string kind, int count) in counts)
        {
            json.WriteNumber(kind, count);
        }

        json.WriteEndObject();
    }

    private static void WriteCorner(Utf8JsonWriter json, string key, System.Numerics.Vector3? corner)
    {
        if (corner is not { } point)
        {
            json.WriteNull(key);
            return;
        }

        json.WriteStartArray(key);
        json.WriteNumberValue(point.X);
        json.WriteNumberValue(point.Y);
        json.WriteNumberValue(point.Z);
        json.WriteEndArray();
    }
}
