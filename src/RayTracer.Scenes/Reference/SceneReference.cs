using System.Text;
using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>Makes the reference page of the scene format, in Markdown, from the description records.</summary>
public static class SceneReference
{
    /// <summary>The scene that the page shows as an example.</summary>
    public const string Example = """
        {
          "$schema": "../scenes/raytracer.schema.json",
          "camera": { "position": [0, 1.2, 4], "lookAt": [0, 0.5, 0], "fieldOfView": 40 },
          "render": { "width": 600, "height": 600, "samplesPerPixel": 16 },
          "background": "skyblue",          // a colour: a CSS name, "#rrggbb" or [red, green, blue]
          "textures": {
            "tiles": { "type": "checker", "even": "white", "odd": "#335577" },
          },
          "materials": {
            "mirror": { "type": "phongMetal", "color": [0.9, 0.9, 0.9] },
            "polished": { "type": "diffuseSpecular", "diffuse": { "type": "diffuse", "color": "tiles" }, "specular": "mirror" },
          },
          "shapes": [
            { "type": "sphere", "name": "globe", "center": [0, 0.5, 0], "radius": 0.5, "material": "polished" },
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": "tiles" } },
          ],
          "lights": [
            { "type": "sphere", "center": [2, 4, 1], "radius": 0.3, "material": { "type": "luminaire", "multiplier": 5 } },
          ],
        }
        """;

    private const string Introduction = """
        # The scene format

        A scene is a JSON file in UTF-8. `//` and `/* */` comments and commas before a closing bracket are allowed.
        A key that is not listed here, a key that appears twice, or a value out of its range is an error: nothing is ignored.
        With `"$schema"` at the top, editors complete and check what is typed.

        """;

    private const string Conventions = """
        ## Conventions

        - **Space** is right-handed with y up: x to the right, y up, z towards the viewer. Lengths have no fixed unit
          ("scene units"). Angles are in degrees.
        - **Vectors** are written `[x, y, z]`, pairs `[u, v]`.
        - **Colours** are linear sRGB (Rec. 709 primaries). Written as `[red, green, blue]`, or as one number for a grey, they are linear, and 1 is
          white. Written as a CSS name (`"skyblue"`, in lower case) or `"#rgb"` or `"#rrggbb"`, the colour is decoded from sRGB,
          so that it looks as in a browser.
        - **Textures** may be used wherever a material takes a colour: a colour, the name of a texture under `textures`, or a
          texture itself, `{ "type": … }`. Pictures are decoded from sRGB unless they are marked as raw. (0, 0) in uv is
          the lower left corner of a picture, u grows to the right, v upwards. No texture can have the name of a CSS colour.
        - **Materials** are written in place, `{ "type": … }`, or by their names under `materials`. Definitions may come in
          any order and refer to each other, but not in a circle. Records may be nested 16 deep.
        - **Objects** are shapes under a name in `objects`. Any number of instances may show them in other places, and all share
          the memory of one. An object may be made of instances of others.
        - **File paths** are relative to the folder of the scene file.

        """;

    /// <summary>The whole page, with \n at each line's end.</summary>
    public static string Generate()
    {
        StringBuilder page = new(Introduction);
        page.Append($"\n```jsonc\n{Example}\n```\n\n").Append(Conventions);
        page.Append("## The scene and its parts\n\n");
        foreach (RecordType part in SceneTypes.Parts)
        {
            Section(page, part, part == SceneTypes.Scene ? "The whole file." : "");
        }

        foreach (TypeFamily family in SceneTypes.Families)
        {
            page.Append($"## {Capital(family.Noun)}s\n\n");
            foreach (RecordType type in family.Types)
            {
                Section(page, type, $"{type.Summary} Written `\"type\": \"{type.Name}\"`.");
            }
        }

        return page.ToString().TrimEnd() + "\n";
    }

    private static void Section(StringBuilder page, RecordType type, string summary)
    {
        page.Append($"### {type.Name}\n\n");
        if (summary.Length > 0)
        {
            page.Append(summary).Append("\n\n");
        }

        page.Append("| parameter | type | unit | range | default | meaning |\n|---|---|---|---|---|---|\n");
        foreach (RecordParameter parameter in type.Parameters)
        {
            page.Append($"| `{parameter.Key}` | {ParameterForm.Of(parameter).Words(parameter)} | {parameter.Unit} | {parameter.Range} | {Default(parameter)} | {parameter.Summary} |\n");
        }

        page.Append('\n');
    }

    internal static string Default(RecordParameter parameter)
    {
        if (parameter.Required)
        {
            return "**required**";
        }

        return parameter.Default switch
        {
            null or "" or System.Collections.ICollection => "none",
            _ when parameter.IsRecord => "all defaults",
            { } value => $"`{SceneWriter.WriteValue(parameter, value)}`",
        };
    }

    private static string Capital(string noun) => char.ToUpperInvariant(noun[0]) + noun[1..];
}
