using System.Numerics;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Extensions.Tests;

/// <summary>The four numbers of a rotation, its real part last.</summary>
public sealed class QuaternionForm() : VectorForm<Quaternion>("quaternion", 4, q => new(q[0], q[1], q[2], q[3]), q => [q.X, q.Y, q.Z, q.W])
{
    /// <inheritdoc/>
    public override string Words(RecordParameter parameter) => "[x, y, z, w]";
}
