-- | Parts of a whole that it may lack, like the disk of a scene.
module BlackHole.Scene.Field.Part
  ( Part (..),
    inside,
  )
where

import Control.Monad ((>=>))

-- | A part of a whole, which may lack it: how to get the part, and how to replace it.
data Part whole part = Part
  { partOf :: !(whole -> Maybe part),
    partSet :: !(part -> whole -> whole)
  }

-- | A part of a part. Replaces nothing if the outer part is missing.
inside :: Part whole middle -> Part middle part -> Part whole part
inside outer inner =
  Part
    { partOf = partOf outer >=> partOf inner,
      partSet = \p w -> maybe w (\m -> partSet outer (partSet inner p m) w) (partOf outer w)
    }
