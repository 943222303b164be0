using System.Numerics;
using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;
using JsonNode = RayTracer.Scenes.JsonNode;

namespace RayTracer.Session;

/// <summary>Makes the text of things that are to be added to a scene.</summary>
internal static class NewThing
{
    /// <summary>The place in the middle of the picture that the camera of a scene's text takes.</summary>
    public static SketchView View(JsonNode root)
    {
        SceneValue scene = SceneValue.Scene(root);
        CameraDescription camera = (CameraDescription)scene.Child("camera")!.Record();
        Vector3 back = camera.Position - camera.LookAt;
        float distance = back.Norm();
        if (!(distance > 0) || !float.IsFinite(distance))
        {
            return new(camera.LookAt, Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ, 1);
        }

        Vector3 towards = back * (1 / distance);
        Vector3 right = camera.Up.Cross(towards).Unit();
        right = right.IsFinite() ? right : Vector3.UnitX;
        SceneValue render = scene.Child("render")!;
        float height = CameraMotion.HeightAt(camera, distance, render.Number("width") / render.Number("height"));
        return new(camera.LookAt, right, towards.Cross(right), towards, PlaceInView.Round(height / 8));
    }

    /// <summary>A shape where it is seen at once.</summary>
    /// <param name="type">Its type.</param>
    /// <param name="view">The place and the size.</param>
    /// <param name="objectName">The object that an instance shows; null where there is none.</param>
    /// <exception cref="SessionException">There is nothing that an instance could show, or a model has no file.</exception>
    public static JsonObject Shape(RecordType type, SketchView view, string? objectName)
    {
        JsonObject shape = Written(((ShapeDescription)type.Create()).Sketch(view), type, objectName);
        if (view.Shines && !type.IsLight)
        {
            shape["material"] = new JsonObject { ["type"] = "luminaire", ["multiplier"] = SketchView.LampRadiance };
        }

        return shape;
    }

    /// <summary>Returns whether a shape is made of the material that it is given: what stands in files and objects has materials of its own.</summary>
    public static bool NeedsMaterial(RecordType type) => !type.IsLight && !type.Parameters.Any(p => p.Required && (p.IsFile || (p.Family == SceneTypes.Shapes && !p.IsList)));

    /// <summary>A material, texture or environment with its default values, of which the colour is written.</summary>
    /// <exception cref="SessionException">It needs a file and has none.</exception>
    public static JsonObject Plain(RecordType type, string? file)
    {
        JsonObject thing = new() { ["type"] = type.Name };
        object record = type.Create();
        foreach (RecordParameter parameter in type.Parameters)
        {
            bool isShown = parameter.Required || parameter.Key is "color" or "even" or "odd" or "refractiveIndex" or "exponent" or "scale";
            if (parameter is { Required: true, IsFile: true })
            {
                thing[parameter.Key] = file ?? throw new SessionException($"a {type.Name} needs a file");
            }
            else if (isShown && parameter.Get(record) is { } value)
            {
                thing[parameter.Key] = JsonValues.Of(parameter, value);
            }
        }

        return thing;
    }

    // What must be written, what is not as it would be anyway, and all lengths, so that the text says how large it is.
    private static JsonObject Written(ShapeDescription shape, RecordType type, string? objectName)
    {
        JsonObject json = new() { ["type"] = type.Name };
        foreach (RecordParameter parameter in type.Parameters)
        {
            object? value = parameter.Get(shape);
            if (parameter.Required && value is null or "")
            {
                json[parameter.Key] = parameter.IsFile ? throw new SessionException("open or drop the model's file to add it")
                    : objectName ?? throw new SessionException("an instance shows one of the scene's objects, and there are none");
            }
            else if (value is IReadOnlyList<ShapeDescription> shapes)
            {
                json[parameter.Key] = new JsonArray([.. shapes.Select(s => Written(s, RecordType.Of(s.GetType()), objectName))]);
            }
            else if (value is not System.Collections.ICollection { Count: 0 }
                && (parameter.Required || !Equals(value, parameter.Default) || (parameter.Unit == "scene units" && value is > 0f)))
            {
                json[parameter.Key] = JsonValues.Rounded(parameter, value);
            }
        }

        return json;
    }
}
