-- | All checks of the self-test.
module BlackHole.SelfTest.Suite
  ( selfTestChecks,
  )
where

import BlackHole.SelfTest.Check (Check)
import BlackHole.SelfTest.Physics (physicsChecks)
import BlackHole.SelfTest.Picture (pictureChecks)

-- | The checks in the order of the table. Renders small pictures, which takes a
-- fraction of a second in all.
selfTestChecks :: IO [Check]
selfTestChecks = (physicsChecks ++) <$> pictureChecks
