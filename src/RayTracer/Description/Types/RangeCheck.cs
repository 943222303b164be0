namespace RayTracer.Description;

/// <summary>
/// Reports the parameters of records that are out of their ranges, or null where they must not be; each record is checked once.
/// </summary>
internal sealed class RangeCheck(Action<SceneComplaint> complain)
{
    private readonly HashSet<object> _seen = new(ReferenceEqualityComparer.Instance);

    /// <summary>Checks a record and all that it consists of.</summary>
    /// <returns>True if nothing was reported.</returns>
    public bool IsGood(object root)
    {
        bool isGood = true;
        Queue<object> records = new([root]);
        while (records.TryDequeue(out object? record))
        {
            if (_seen.Add(record))
            {
                isGood &= IsGood(record, records);
            }
        }

        return isGood;
    }

    // Of what is at fault, the parts are not looked at: a texture's colours would be reported twice.
    private bool IsGood(object record, Queue<object> parts)
    {
        bool isGood = true;
        RecordType type = RecordType.Of(record.GetType());
        foreach (RecordParameter parameter in type.Parameters)
        {
            object? value = parameter.Get(record);
            if (parameter.Complaint(value) is { } complaint)
            {
                complain(new(record, parameter.PropertyName, $"{Quotation.Of(parameter.Key)} {complaint}", true) { IsOutOfRange = true });
                isGood = false;
                continue;
            }

            foreach (object part in parameter.RecordsIn(value))
            {
                parts.Enqueue(part);
            }
        }

        return isGood;
    }
}
