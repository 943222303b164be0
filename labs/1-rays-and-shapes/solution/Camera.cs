namespace Lab1;

/// <summary>An eye that looks through a window, which is divided into pixels.</summary>
public sealed class Camera
{
    private readonly Vector _eye;
    private readonly Vector _forward;
    private readonly Vector _right;
    private readonly Vector _up;
    private readonly double _tangent;
    private readonly int _width;
    private readonly int _height;

    /// <summary>Makes one.</summary>
    /// <param name="eye">Where the eye is.</param>
    /// <param name="lookAt">The point in the middle of the picture.</param>
    /// <param name="fieldOfView">The angle between the bottom and the top edge of the picture, in degrees.</param>
    /// <param name="width">Width of the picture in pixels.</param>
    /// <param name="height">Height of the picture in pixels.</param>
    public Camera(Vector eye, Vector lookAt, double fieldOfView, int width, int height)
    {
        (_eye, _width, _height) = (eye, width, height);

        // Three directions of length 1, perpendicular to each other; (0, 1, 0) is up in the world.
        _forward = (lookAt - eye).Unit;
        _right = Vector.Cross(_forward, new(0, 1, 0)).Unit;
        _up = Vector.Cross(_right, _forward);
        _tangent = Math.Tan(fieldOfView / 2 * Math.PI / 180);
    }

    /// <summary>The ray through a point of the picture.</summary>
    /// <param name="x">Column, in pixels from the left edge; 0.5 is the middle of the first pixel.</param>
    /// <param name="y">Row, in pixels from the top edge; 0.5 is the middle of the first pixel.</param>
    /// <returns>A ray from the eye, with a direction of length 1.</returns>
    public Ray RayThrough(double x, double y)
    {
        //? Camera.RayThrough: find the point of the window at distance 1, and the direction to it.
        double side = 2 * _tangent / _height;
        Vector window = _forward
            + ((x - (0.5 * _width)) * side * _right)
            + (((0.5 * _height) - y) * side * _up);
        return new(_eye, window.Unit);
        //!
    }
}
