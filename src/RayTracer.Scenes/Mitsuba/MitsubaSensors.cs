using System.Globalization;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Scenes;

/// <summary>Makes cameras, and sizes and samples of pictures.</summary>
internal sealed class MitsubaSensors(MitsubaReading reading)
{
    private static readonly Dictionary<string, FieldOfViewAxis> s_axes = new()
    {
        ["x"] = FieldOfViewAxis.Horizontal,
        ["y"] = FieldOfViewAxis.Vertical,
        ["diagonal"] = FieldOfViewAxis.Diagonal,
        ["smaller"] = FieldOfViewAxis.Smaller,
        ["larger"] = FieldOfViewAxis.Larger,
    };

    /// <summary>A scene with a sensor's camera, size, filter and samples.</summary>
    public SceneDescription Read(MitsubaObject sensor, SceneDescription scene)
    {
        sensor.Ignore("near_clip", "far_clip", "shutter_open", "shutter_close", "srf");
        CameraDescription? camera = sensor.Type switch
        {
            "perspective" => Perspective(sensor),
            "thinlens" => Perspective(sensor) with
            {
                Lens = new() { ApertureRadius = sensor.Float("aperture_radius", 0, 0), FocusDistance = sensor.Float("focus_distance", 0, 0) },
            },
            "orthographic" => Orthographic(sensor),
            _ => null,
        };
        if (camera is null)
        {
            reading.Log.Unknown(sensor.TypePlace, $"sensors of the type {Quotation.Of(sensor.Type)} are not read here", sensor.Type, ["perspective", "thinlens", "orthographic"]);
            return scene;
        }

        RenderDescription render = scene.Render;
        if (sensor.Only("sampler") is { } sampler)
        {
            render = MitsubaSamplers.Read(sampler, render);
        }
        else
        {
            render = render with { SamplesPerPixel = MitsubaSamplers.StandardCount, Sampler = SamplerKind.Independent };
        }

        FilmRead film = MitsubaFilms.Read(sensor.Only("film"), render);
        camera = camera with { Window = film.Window };
        MitsubaMedia.Around(sensor);
        sensor.Finish();
        return scene with { Camera = reading.At(sensor.Place, camera), Render = reading.At(sensor.Place, film.Render) };
    }

    private CameraDescription Perspective(MitsubaObject sensor)
    {
        CameraDescription camera = Placed(sensor, out _);
        foreach (string name in new[] { "principal_point_offset_x", "principal_point_offset_y" })
        {
            if (sensor.Float(name, 0) != 0)
            {
                reading.Log.Error(sensor.PlaceOf(name), "a principal point beside the middle of the picture is not read here");
            }
        }

        if (sensor.Text("focal_length") is { } focal)
        {
            return camera with { FieldOfView = FieldOfView(focal, sensor), FieldOfViewAxis = FieldOfViewAxis.Diagonal };
        }

        if (!sensor.Has("fov"))
        {
            reading.Log.Error(sensor.Place, $"{sensor.Describe()} needs \"fov\", or \"focal_length\"");
        }

        return camera with { FieldOfView = sensor.Float("fov", 40), FieldOfViewAxis = sensor.Choice("fov_axis", FieldOfViewAxis.Horizontal, s_axes) };
    }

    private CameraDescription Orthographic(MitsubaObject sensor)
    {
        CameraDescription camera = Placed(sensor, out Vector3 scale);
        if (float.Abs(scale.X - scale.Y) > 1e-4f * scale.X)
        {
            reading.Log.Error(sensor.PlaceOf("to_world"), "an orthographic sensor that is scaled differently along x and y is not read here");
        }

        return camera with { Projection = Projection.Orthographic, ViewSize = 2 * scale.X, FieldOfViewAxis = FieldOfViewAxis.Horizontal };
    }

    // The sensor looks along z of its own frame, has y up and x to the left.
    private CameraDescription Placed(MitsubaObject sensor, out Vector3 scale)
    {
        Transform place = sensor.Transform();
        if (place.Determinant < 0)
        {
            reading.Log.Error(sensor.PlaceOf("to_world"), "a sensor that is mirrored is not read here");
        }

        Vector3 position = place.Point(Vector3.Zero);
        Vector3 up = place.Vector(Vector3.UnitY);
        scale = new(place.Vector(Vector3.UnitX).Norm(), up.Norm(), 1);
        return new() { Position = position, LookAt = position + place.Vector(Vector3.UnitZ).Unit(), Up = up.Unit() };
    }

    // Of a film of 36 mm × 24 mm, over its diagonal.
    private float FieldOfView(string focal, MitsubaObject sensor)
    {
        string number = focal.EndsWith("mm", StringComparison.Ordinal) ? focal[..^2] : focal;
        if (!float.TryParse(number, NumberStyles.Float, CultureInfo.InvariantCulture, out float length) || !(length > 0))
        {
            reading.Log.Error(sensor.PlaceOf("focal_length"), $"expected a focal length such as \"50mm\", but found {Quotation.Of(focal)}");
            return 40;
        }

        return 2 * LaneMath.Atan2(float.Sqrt((36 * 36) + (24 * 24)) / 2, length) * (180 / float.Pi);
    }
}
