using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Acceleration;

/// <summary>Finds the instances that a ray may meet.</summary>
internal sealed class InstanceTree(InstanceTable table, float[] boxes)
{
    /// <summary>Memory of the tree.</summary>
    public long MemoryBytes => boxes.Length * 4L;

    /// <summary>Shortens a ray to the nearest hit of all instances.</summary>
    public void ClosestHit(in SpaceRay ray, float time, ref InstanceHit hit)
    {
        for (int i = 1; i <= table.Count; i++)
        {
            if (MayMeet(ray, i, hit.Distance))
            {
                table.Meet(i, ray, time, ref hit);
            }
        }
    }

    /// <summary>Whether any instance stands in the way of a ray.</summary>
    public bool AnyHit(in SpaceRay ray, float time, float distance, int skipped, int skip)
    {
        for (int i = 1; i <= table.Count; i++)
        {
            if (MayMeet(ray, i, distance) && table.IsMet(i, ray, time, distance, i == skipped ? skip : -1))
            {
                return true;
            }
        }

        return false;
    }

    private bool MayMeet(in SpaceRay ray, int instance, float distance)
    {
        ReadOnlySpan<float> box = boxes.AsSpan(6 * (instance - 1), 6);
        Vector3 low = (new Vector3(box[0], box[1], box[2]) - ray.Origin) / ray.Direction;
        Vector3 high = (new Vector3(box[3], box[4], box[5]) - ray.Origin) / ray.Direction;
        float enter = Vector3.Min(low, high).Largest();
        float leave = -(-Vector3.Max(low, high)).Largest();
        return !(enter > leave * 1.0001f) && !(leave < 0) && !(enter > distance);
    }
}
