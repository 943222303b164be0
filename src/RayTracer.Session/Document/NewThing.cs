using System.Numerics;
using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;
using Json = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Session;

/// <summary>Makes things that are to be added to a scene: such as can be seen at once.</summary>
internal static class NewThing
{
    // Radiance of a new lamp: what a lamp of the size of new things needs to light what is around it.
    private const double LampRadiance = 20;

    // What a sun brings onto a white floor, in the same units.
    private const float SunIrradiance = 3;

    /// <summary>A shape.</summary>
    /// <param name="type">Its type.</param>
    /// <param name="view">What the camera sees.</param>
    /// <param name="at">Where its middle is to be.</param>
    /// <param name="objectName">The object that an instance shows; null where there is none.</param>
    /// <param name="file">The file of a model; null where there is none.</param>
    /// <exception cref="DocumentException">There is nothing that an instance could show, or a model has no file.</exception>
    public static JsonObject Shape(RecordType type, SceneView view, Vector3 at, string? objectName, string? file)
    {
        float s = view.Size;
        JsonObject shape = new() { ["type"] = type.Name };
        void Set(string key, Vector3 value) => shape[key] = Round(value, s);
        void Length(string key, float value) => shape[key] = JsonValues.Number(value);
        switch (type.Name)
        {
            case "sphere":
                Set("center", at);
                Length("radius", s);
                break;
            case "box":
                Set("a", at - new Vector3(s));
                Set("b", at + new Vector3(s));
                break;
            case "cylinder" or "cone":
                Set("bottom", at - new Vector3(0, s, 0));
                Set("top", at + new Vector3(0, s, 0));
                Length("radius", 0.6f * s);
                break;
            case "torus":
                Set("center", at);
                Length("radius", s);
                Length("tubeRadius", 0.3f * s);
                break;
            case "disk":
                Set("center", at);
                shape["normal"] = JsonValues.Vector(Facing(view));
                Length("radius", s);
                break;
            case "plane":
                Set("point", at);
                shape["normal"] = new JsonArray(0, 1, 0);
                break;
            case "rectangle":
                Set("corner", at - ((view.Right + view.Up) * s));
                Set("edgeU", view.Right * (2 * s));
                Set("edgeV", view.Up * (2 * s));
                break;
            case "triangle":
                Set("a", at - ((view.Right + view.Up) * s));
                Set("b", at + ((view.Right - view.Up) * s));
                Set("c", at + (view.Up * s));
                break;
            case "point" or "spot":
                Set("position", at + Above(view));
                shape["intensity"] = JsonValues.Vector(new((float)(LampRadiance * s * s)));
                if (type.Name == "spot")
                {
                    shape["direction"] = JsonValues.Vector(-Above(view).Unit());
                    shape["cutoffAngle"] = 30;
                }

                break;
            case "directional":
                shape["direction"] = new JsonArray(-1, -2, -1);
                shape["irradiance"] = JsonValues.Vector(new(SunIrradiance));
                break;
            case "group":
                shape["shapes"] = new JsonArray(Shape(SceneTypes.Shapes.Find("sphere")!, view, at, null, null));
                break;
            case "mesh" when file is null:
                Pyramid(shape, at, s);
                break;
            case "mesh" or "model":
                shape["file"] = file ?? throw new DocumentException("open or drop the model's file to add it");
                break;
            case "instance":
                shape["of"] = objectName ?? throw new DocumentException("an instance shows one of the scene's objects, and there are none");
                shape["transform"] = new JsonArray(new JsonObject { ["translate"] = Round(at, s) });
                break;
            default:
                shape = Plain(type, file);
                break;
        }

        return shape;
    }

    /// <summary>What makes a shape shine.</summary>
    public static JsonObject Lamp() => new() { ["type"] = "luminaire", ["multiplier"] = LampRadiance };

    /// <summary>A material or texture with its default values, of which the colour is written.</summary>
    /// <exception cref="DocumentException">It needs a file and has none.</exception>
    public static JsonObject Plain(RecordType type, string? file)
    {
        JsonObject thing = new() { ["type"] = type.Name };
        object record = type.Create();
        foreach (RecordParameter parameter in type.Parameters)
        {
            bool isShown = parameter.Required || parameter.Key is "color" or "even" or "odd" or "refractiveIndex" or "exponent" or "scale";
            if (parameter is { Required: true, Kind: ParameterKind.File })
            {
                thing[parameter.Key] = file ?? throw new DocumentException($"a {type.Name} needs a file");
            }
            else if (isShown && parameter.Get(record) is { } value)
            {
                thing[parameter.Key] = JsonValues.Of(value);
            }
        }

        return thing;
    }

    private static void Pyramid(JsonObject mesh, Vector3 at, float s)
    {
        Vector3[] corners = [new(-1, -1, -1), new(1, -1, -1), new(1, -1, 1), new(-1, -1, 1), new(0, 1, 0)];
        mesh["positions"] = new JsonArray([.. corners.Select(c => (Json)Round(at + (c * s), s))]);
        int[][] triangles = [[0, 1, 2], [0, 2, 3], [0, 4, 1], [1, 4, 2], [2, 4, 3], [3, 4, 0]];
        mesh["triangles"] = new JsonArray([.. triangles.Select(t => (Json)new JsonArray(t[0], t[1], t[2]))]);
    }

    // From a thing to a light that is put up for it: above, and before it.
    private static Vector3 Above(SceneView view) => ((view.Up * 3) + (view.Towards * 2)) * view.Size;

    // Along the axis that points most at the camera.
    private static Vector3 Facing(SceneView view)
    {
        Vector3 a = Vector3.Abs(view.Towards);
        int axis = a.X > a.Y && a.X > a.Z ? 0 : a.Y > a.Z ? 1 : 2;
        Vector3 facing = default;
        facing[axis] = view.Towards[axis] < 0 ? -1 : 1;
        return facing;
    }

    // To hundredths of the size of new things.
    private static JsonArray Round(Vector3 v, float size)
    {
        double step = size / 100;
        return new(Snap(v.X), Snap(v.Y), Snap(v.Z));

        Json Snap(double x) => JsonValues.Number(Math.Round(x / step) * step);
    }
}
