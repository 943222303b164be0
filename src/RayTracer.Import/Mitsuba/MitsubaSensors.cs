using System.Globalization;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>Makes cameras, and sizes and samples of pictures.</summary>
internal sealed class MitsubaSensors(ImportReading reading)
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
        WarnOfClipping(sensor);

        // Without an aperture, everything is sharp.
        sensor.Ignore("shutter_open", "shutter_close", "srf", "focus_distance");
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
            sensor.UnknownType("sensors", "perspective", "thinlens", "orthographic");
            if (!reading.Log.IsLenient)
            {
                return scene;
            }

            camera = Perspective(sensor);
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
        camera = Shifted(sensor, camera, film.Window);
        MitsubaMedia.WarnOfSensorMedium(sensor);
        sensor.Finish();
        return scene with { Camera = reading.At(sensor.Place, camera), Render = reading.At(sensor.Place, film.Render) };
    }

    // Planes so near to the camera, or so far, are there to be out of the way.
    private void WarnOfClipping(MitsubaObject sensor)
    {
        foreach ((string name, bool cuts) in new[] { ("near_clip", sensor.Float("near_clip", 0) > 0.1f), ("far_clip", sensor.Float("far_clip", float.MaxValue) < 100) })
        {
            if (cuts)
            {
                reading.Log.Warn(sensor.PlaceOf(name), $"{Quotation.Of(name)} does not clip here: everything in front of the camera is visible");
            }
        }
    }

    private CameraDescription Perspective(MitsubaObject sensor)
    {
        CameraDescription camera = Placed(sensor, out _);
        return camera with { FieldOfView = FieldOfView(sensor, out FieldOfViewAxis axis), FieldOfViewAxis = axis };
    }

    /// <summary>The field of view of a camera or projector.</summary>
    /// <param name="thing">The camera or projector.</param>
    /// <param name="axis">The axis over which it is meant.</param>
    public static float FieldOfView(MitsubaObject thing, out FieldOfViewAxis axis)
    {
        string? focal = thing.Text("focal_length");
        axis = thing.Choice("fov_axis", FieldOfViewAxis.Horizontal, s_axes);
        if (focal is not null || !thing.Has("fov"))
        {
            axis = FieldOfViewAxis.Diagonal;
            return FieldOfView(focal ?? "50mm", thing);
        }

        return thing.Float("fov", 40, 0.001f, 179);
    }

    // The axis meets the film beside its middle: the film is a part of a larger one, whose middle it meets.
    private CameraDescription Shifted(MitsubaObject sensor, CameraDescription camera, IReadOnlyList<float> window)
    {
        float x = sensor.Float("principal_point_offset_x", 0);
        float y = sensor.Float("principal_point_offset_y", 0);
        if (x == 0 && y == 0)
        {
            return camera with { Window = window };
        }

        if (camera.Projection != Projection.Perspective)
        {
            reading.Log.Error(sensor.Place, "an off-centre principal point is supported for perspective sensors only");
            return camera;
        }

        float larger = 1 + (2 * float.Max(float.Abs(x), float.Abs(y)));
        IReadOnlyList<float> inner = window.Count > 0 ? window : [0, 0, 1, 1];
        LaneMath.SinCosTurn(camera.FieldOfView / 720, out float sin, out float cos);
        return camera with
        {
            FieldOfView = LaneMath.Atan2(larger * sin, cos) * (360 / float.Pi),
            Window = [(((larger - 1) / 2) + x + inner[0]) / larger, (((larger - 1) / 2) + y + inner[1]) / larger, inner[2] / larger, inner[3] / larger],
        };
    }

    private CameraDescription Orthographic(MitsubaObject sensor)
    {
        CameraDescription camera = Placed(sensor, out Vector3 scale);
        if (float.Abs(scale.X - scale.Y) > 1e-4f * scale.X)
        {
            reading.Log.Error(sensor.PlaceOf("to_world"), "an orthographic sensor that is scaled differently along x and y is not supported");
        }

        return camera with { Projection = Projection.Orthographic, ViewSize = 2 * scale.X, FieldOfViewAxis = FieldOfViewAxis.Horizontal };
    }

    // The sensor looks along z of its frame, has y up and x to the left.
    private CameraDescription Placed(MitsubaObject sensor, out Vector3 scale)
    {
        Transform place = sensor.Transform();
        if (place.Determinant < 0)
        {
            reading.Log.Error(sensor.PlaceOf("to_world"), "a mirrored sensor is not supported");
        }

        Vector3 position = place.Point(Vector3.Zero);
        Vector3 up = place.Vector(Vector3.UnitY);
        scale = new(place.Vector(Vector3.UnitX).Norm(), up.Norm(), 1);
        return new() { Position = position, LookAt = position + place.Vector(Vector3.UnitZ).Unit(), Up = up.Unit() };
    }

    // Of a film of 36 mm × 24 mm, over its diagonal.
    private static float FieldOfView(string focal, MitsubaObject thing)
    {
        string number = focal.EndsWith("mm", StringComparison.Ordinal) ? focal[..^2] : focal;
        if (!float.TryParse(number, NumberStyles.Float, CultureInfo.InvariantCulture, out float length) || !(length > 0))
        {
            thing.Log.Error(thing.PlaceOf("focal_length"), $"expected a focal length such as \"50mm\", but found {Quotation.Of(focal)}");
            return 40;
        }

        return 2 * LaneMath.Atan2(float.Sqrt((36 * 36) + (24 * 24)) / 2, length) * (180 / float.Pi);
    }
}
